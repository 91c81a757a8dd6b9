#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "model/export/drawings/deflated_stream.h"
#include "model/text/file_writer.h"

namespace model {

/// Writes the objects of a PDF file one after the other; what it takes for streams, compressed, and for its end, the
/// table of objects.
class PdfFile {
public:
    /// Writes the first lines.
    explicit PdfFile(FileWriter& file);

    /// A number for an object that is written later.
    [[nodiscard]] int reserve();
    void addObject(int number, std::string_view body);

    /// A stream of any length; no other object until endStream(). `entries` go into its dictionary.
    void beginStream(int number, std::string_view entries = {});
    void addToStream(std::string_view text) { m_stream->add(text); }
    void endStream();

    /// `catalog` and `info` are objects that were written.
    void end(int catalog, int info);

private:
    void start(int number);

    FileWriter& m_file;
    std::vector<std::uint64_t> m_starts;     ///< where an object starts, by number - 1
    std::optional<DeflatedStream> m_stream;  ///< between beginStream() and endStream()
    std::uint64_t m_streamStart = 0;
    int m_length = 0;  ///< the object that holds the length of the stream
};

/// A string of a font with WinAnsiEncoding, in hexadecimal digits: of other characters than those of Latin a question
/// mark.
[[nodiscard]] std::string pdfLatin(std::string_view utf8);

/// A text string: UTF-16 in hexadecimal digits.
[[nodiscard]] std::string pdfText(std::string_view utf8);

}  // namespace model
