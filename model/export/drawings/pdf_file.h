#pragma once

#include <zlib.h>

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "model/text/file_writer.h"

namespace model {

/// Writes the objects of a PDF file one after the other; what it takes for streams, compressed, and for its end, the
/// table of objects.
class PdfFile {
public:
    /// Writes the first lines.
    explicit PdfFile(FileWriter& file);
    ~PdfFile();
    PdfFile(const PdfFile&) = delete;
    PdfFile& operator=(const PdfFile&) = delete;

    /// A number for an object that is written later.
    [[nodiscard]] int reserve();
    void addObject(int number, std::string_view body);

    /// A stream of any length; no other object until endStream().
    void beginStream(int number);
    void addToStream(std::string_view text);
    void endStream();

    /// `catalog` and `info` are objects that were written.
    void end(int catalog, int info);

private:
    void start(int number);
    void compress(int flush);

    FileWriter& m_file;
    std::vector<std::uint64_t> m_starts;  ///< where an object starts, by number - 1
    z_stream m_deflate{};
    std::string m_pending;  ///< of the stream, not yet compressed
    std::uint64_t m_streamStart = 0;
    int m_length = 0;  ///< the object that holds the length of the stream
};

/// A text string: UTF-16 in hexadecimal digits.
[[nodiscard]] std::string pdfText(std::string_view utf8);

}  // namespace model
