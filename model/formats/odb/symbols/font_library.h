#pragma once

#include <map>
#include <string>
#include <string_view>

#include "model/formats/common/font.h"
#include "model/formats/odb/text/job_tree.h"

namespace model::odb {

/// A font as `fonts/<name>` of a job defines it:
///
///     XSIZE 0.302     width of a character with the space behind it
///     YSIZE 0.302     height
///     OFFSET 0        added to the width
///     CHAR A
///     LINE xs ys xe ye P|N R|S width
///     ECHAR
[[nodiscard]] formats::Font parseFont(std::string_view text, std::string_view path, Diagnostics& diagnostics);

/// The fonts of a job by name, each read when it is first needed. A job without the font gets the stand-in, which is
/// reported where it was needed first.
class FontLibrary {
public:
    FontLibrary(const formats::FileTree& job, Diagnostics& diagnostics) : m_job(job), m_diagnostics(diagnostics) {}

    const formats::Font& font(const std::string& name, std::string_view path, std::uint32_t line);

private:
    const formats::FileTree& m_job;
    Diagnostics& m_diagnostics;
    std::map<std::string, formats::Font> m_fonts;
};

}  // namespace model::odb
