#include "model/formats/file_kinds.h"

#include <algorithm>

namespace model {

namespace {

struct Kind {
    std::string_view begin;
    std::string_view name;
    std::string_view word = {};  ///< stands somewhere in the first bytes too
};

using namespace std::string_view_literals;

/// The first row that fits counts.
constexpr Kind kKinds[] = {
    {"\x89PNG", "a PNG picture"},
    {"\xff\xd8\xff", "a JPEG picture"},
    {"GIF8", "a GIF picture"},
    {"BM", "a BMP picture"},
    {"%PDF", "a PDF document"},
    {"PK", "a ZIP archive"},
    {"\x1f\x8b", "a gzip archive"},
    {"\x1f\x9d", "a compressed archive"},
    {"7z\xbc\xaf", "a 7z archive"},
    {"Rar!", "a RAR archive"},
    {"\xd0\xcf\x11\xe0", "an Altium board or another OLE file"},
    {"\x7f"
     "ELF"sv,
     "a program"},
    {"(kicad_pcb", "a KiCad board"},
    {"(kicad_", "a KiCad file"},
    {"(footprint", "a KiCad footprint"},
    {"(module", "a KiCad footprint"},
    {"PCBNEW-BOARD", "a board from before KiCad 4 (KiCad saves it as .kicad_pcb)"},
    {"%FS", "a Gerber file"},
    {"%TF", "a Gerber file"},
    {"%MO", "a Gerber file"},
    {"G04", "a Gerber file"},
    {"M48", "an Excellon drill file"},
    {"ISO-10303-21", "a STEP model"},
    {"<", "an IPC-2581 board", "<IPC-2581"},
    {"<", "an EAGLE board", "<eagle"},
    {"<", "an SVG drawing", "<svg"},
    {"<", "a web page", "<html"},
    {"<", "an XML file"},
    {"{", "a KiCad project (its board is the .kicad_pcb beside it)", "\"3dviewports\""},
    {"{", "a KiCad project (its board is the .kicad_pcb beside it)", "\"design_settings\""},
    {"{", "a JSON file"},
};

bool isText(std::string_view head) {
    return std::ranges::none_of(head, [](char c) {
        const auto byte = static_cast<unsigned char>(c);
        return byte < 0x20 && c != '\t' && c != '\r' && c != '\n';
    });
}

/// Without a byte order mark and leading blanks.
std::string_view trimmedFront(std::string_view head) {
    if (head.starts_with("\xef\xbb\xbf")) {
        head.remove_prefix(3);
    }
    return head.substr(std::min(head.find_first_not_of(" \t\r\n"), head.size()));
}

}  // namespace

std::string likelyKind(std::string_view head) {
    if (head.empty()) {
        return "an empty file";
    }
    const std::string_view start = trimmedFront(head);
    const auto* const found = std::ranges::find_if(kKinds, [start](const Kind& kind) {
        return start.starts_with(kind.begin) && start.find(kind.word) != std::string_view::npos;
    });
    if (found != std::end(kKinds)) {
        return std::string(found->name);
    }
    return isText(head) ? "a text file" : "a file of unknown kind";
}

std::string firstBytes(std::string_view head) {
    constexpr std::size_t kShown = 8;
    constexpr std::size_t kShownOfText = 24;
    constexpr std::string_view kDigits = "0123456789ABCDEF";
    if (isText(head)) {
        const std::string_view line = trimmedFront(head);
        return '"' + std::string(line.substr(0, std::min(line.find_first_of("\r\n"), kShownOfText))) + '"';
    }
    std::string hex;
    for (const char c : head.substr(0, kShown)) {
        const auto byte = static_cast<unsigned char>(c);
        hex += hex.empty() ? "" : " ";
        hex += {kDigits[byte >> 4U], kDigits[byte & 15U]};
    }
    return hex;
}

}  // namespace model
