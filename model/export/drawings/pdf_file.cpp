#include "model/export/drawings/pdf_file.h"

#include "model/text/formatting.h"
#include "model/text/utf8.h"

namespace model {

PdfFile::PdfFile(FileWriter& file) : m_file(file) {
    m_file.write("%PDF-1.5\n%\xE2\xE3\xCF\xD3\n");
}

int PdfFile::reserve() {
    m_starts.push_back(0);
    return static_cast<int>(m_starts.size());
}

void PdfFile::addObject(int number, std::string_view body) {
    start(number);
    m_file.write(body);
    m_file.write("\nendobj\n");
}

void PdfFile::beginStream(int number, std::string_view entries) {
    m_length = reserve();
    start(number);
    m_file.write("<< " + std::string(entries) + "/Filter /FlateDecode /Length " + std::to_string(m_length) +
                 " 0 R >>\nstream\n");
    m_streamStart = m_file.size();
    m_stream.emplace([this](std::string_view bytes) { m_file.write(bytes); });
}

void PdfFile::endStream() {
    m_stream->end();
    m_stream.reset();
    const std::uint64_t length = m_file.size() - m_streamStart;
    m_file.write("\nendstream\nendobj\n");
    addObject(m_length, std::to_string(length));
}

void PdfFile::end(int catalog, int info) {
    const std::uint64_t table = m_file.size();
    const std::string size = std::to_string(m_starts.size() + 1);
    m_file.write("xref\n0 " + size + "\n0000000000 65535 f \n");
    for (const std::uint64_t at : m_starts) {
        m_file.write(formatted("%010llu 00000 n \n", static_cast<unsigned long long>(at)));
    }
    m_file.write("trailer\n<< /Size " + size + " /Root " + std::to_string(catalog) + " 0 R /Info " +
                 std::to_string(info) + " 0 R >>\nstartxref\n" + std::to_string(table) + "\n%%EOF\n");
}

void PdfFile::start(int number) {
    m_starts[static_cast<std::size_t>(number) - 1] = m_file.size();
    m_file.write(std::to_string(number) + " 0 obj\n");
}

std::string pdfLatin(std::string_view utf8) {
    std::string out = "<";
    while (!utf8.empty()) {
        const Character first = firstCharacter(utf8);
        const bool isLatin =
            (first.code >= 0x20U && first.code < 0x7FU) || (first.code >= 0xA0U && first.code <= 0xFFU);
        out += formatted("%02X", isLatin ? first.code : std::uint32_t{'?'});
        utf8.remove_prefix(first.bytes);
    }
    return out + '>';
}

std::string pdfText(std::string_view utf8) {
    std::string out = "<FEFF";
    while (!utf8.empty()) {
        const Character first = firstCharacter(utf8);
        const std::uint32_t code = first.isSound ? first.code : 0xFFFDU;
        if (code > 0xFFFFU) {
            const std::uint32_t above = code - 0x10000U;
            out += formatted("%04X%04X", 0xD800U + (above >> 10U), 0xDC00U + (above & 0x3FFU));
        } else {
            out += formatted("%04X", code);
        }
        utf8.remove_prefix(first.bytes);
    }
    return out + '>';
}

}  // namespace model
