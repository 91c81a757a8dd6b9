#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "model/formats/registry.h"

/// Which boards lie in a folder or archive: often one board in several forms, what a CAD system exported beside what it
/// saved; sometimes several boards.
namespace model {

/// All forms in the folder or archive of the input and in archives in it, designs first, then the richest format,
/// within a format what lies open before what is packed once more, empty boards last. Safety copies of CAD systems do
/// not count. Archives that cannot be unpacked hold nothing. Errors: Cancelled. What was not looked into is reported in
/// `input.unpacking`.
[[nodiscard]] base::Result<std::vector<BoardForm>> formsIn(BoardInput& input, base::Progress& progress);

/// The file of the form below `path` for people: "export/board-odb.tgz"; empty where it is all that lies there.
[[nodiscard]] std::string fileOf(const BoardForm& form, const std::filesystem::path& path);
/// All but the first, and the options that choose them: "IPC-2581 (board.xml.gz, --input-format ipc2581), …"; not all
/// where there are many.
[[nodiscard]] std::string othersOf(std::span<const BoardForm> forms, const std::filesystem::path& path);

/// Which of several forms was read, the first, and what else is there: "read as KiCad board, a.kicad_pcb; what else …".
[[nodiscard]] std::string choiceText(std::span<const BoardForm> forms, const std::filesystem::path& path);

/// Where all lies that is read for a board: the folder of a job file of Gerber (.gbrjob), which stands for what is
/// beside it; else the path itself, a folder or file.
[[nodiscard]] std::filesystem::path sourceOf(const std::filesystem::path& path);
/// Files beside one that are read with it where they are there: project and rules of a board of KiCad.
[[nodiscard]] std::vector<std::filesystem::path> filesBeside(const std::filesystem::path& path);
/// Is the file, under whatever name, one that may be read where `path`, a folder or file, is opened as a board? In
/// folders by what it is and where it lies, so that reports and pictures there are none.
[[nodiscard]] bool isReadFor(const std::filesystem::path& path, const std::filesystem::path& file);

/// The folder of files that were named together if at least two of them are of one Gerber job; else empty.
[[nodiscard]] std::filesystem::path jobOfFiles(std::span<const std::filesystem::path> files);

/// Is the file of an archive an archive itself, by its name?
[[nodiscard]] bool isNamedLikeArchive(std::string_view name);

}  // namespace model
