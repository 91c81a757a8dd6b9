#include "model/formats/odb/symbols/barcode.h"

#include <algorithm>
#include <array>
#include <optional>

#include "model/base/ascii.h"
#include "model/formats/odb/text/records.h"
#include "model/geometry/outlines.h"

namespace model::odb {

namespace {

/// The characters of code 39; their index is their value in the checksum. The last one starts and stops.
constexpr std::string_view kCharacters = "0123456789ABCDEFGHIJKLMNOPQRSTUVWXYZ-. $/+%*";
constexpr std::size_t kChecked = 43;

/// By character: nine elements, bar and space in turn, w wide and n narrow.
constexpr std::array<std::string_view, 44> kPatterns = {
    "nnnwwnwnn", "wnnwnnnnw", "nnwwnnnnw", "wnwwnnnnn", "nnnwwnnnw", "wnnwwnnnn", "nnwwwnnnn", "nnnwnnwnw", "wnnwnnwnn",
    "nnwwnnwnn", "wnnnnwnnw", "nnwnnwnnw", "wnwnnwnnn", "nnnnwwnnw", "wnnnwwnnn", "nnwnwwnnn", "nnnnnwwnw", "wnnnnwwnn",
    "nnwnnwwnn", "nnnnwwwnn", "wnnnnnnww", "nnwnnnnww", "wnwnnnnwn", "nnnnwnnww", "wnnnwnnwn", "nnwnwnnwn", "nnnnnnwww",
    "wnnnnnwwn", "nnwnnnwwn", "nnnnwnwwn", "wwnnnnnnw", "nwwnnnnnw", "wwwnnnnnn", "nwnnwnnnw", "wwnnwnnnn", "nwwnwnnnn",
    "nwnnnnwnw", "wwnnnnwnn", "nwwnnnwnn", "nwnwnwnnn", "nwnwnnnwn", "nwnnnwnwn", "nnnwnwnwn", "nwnnwnwnn"};

/// Runs of ASCII that full ASCII writes as a shift character and a letter counted from `letter`.
struct AsciiRun {
    char first;
    char last;
    char shift;
    char letter;
};
constexpr std::array<AsciiRun, 12> kPairs = {{{0, 0, '%', 'U'},
                                              {1, 26, '$', 'A'},
                                              {27, 31, '%', 'A'},
                                              {33, 44, '/', 'A'},
                                              {47, 47, '/', 'O'},
                                              {58, 58, '/', 'Z'},
                                              {59, 63, '%', 'F'},
                                              {64, 64, '%', 'V'},
                                              {91, 95, '%', 'K'},
                                              {96, 96, '%', 'W'},
                                              {97, 122, '+', 'A'},
                                              {123, 127, '%', 'P'}}};

std::string fullAscii(char c) {
    for (const AsciiRun& run : kPairs) {
        if (c >= run.first && c <= run.last) {
            return {run.shift, static_cast<char>(run.letter + (c - run.first))};
        }
    }
    return {c};
}

/// The text in characters of code 39; nothing when it has others.
std::optional<std::string> encoded(std::string_view text, bool isFullAscii) {
    std::string all;
    for (const char c : text) {
        const bool isAscii = static_cast<unsigned char>(c) < 128;
        const std::string part = isAscii && isFullAscii ? fullAscii(c) : std::string{base::upperAscii(c)};
        const bool isKnown = part.size() == 2 || kCharacters.substr(0, kChecked).find(part) != std::string_view::npos;
        if (!isAscii || !isKnown) {
            return std::nullopt;
        }
        all += part;
    }
    return all;
}

constexpr double kWide = 3.0;          ///< narrow elements in a wide one
constexpr double kQuietZone = 10.0;    ///< narrow elements beside the bars of an inverted barcode
constexpr double kStringSize = 1.5e6;  ///< the record does not size the text: 1.5 mm,
constexpr double kStringGap = 0.75e6;  ///< half of that away from the bars,
constexpr double kStringFactor = 0.5;  ///< drawn with 6 mil

void addRectangle(ShapeSketch& sketch, PointD low, PointD high, bool isHole) {
    addLoop(sketch, std::array<PointD, 4>{{low, {high.x, low.y}, high, {low.x, high.y}}}, isHole);
}

void addBars(BarcodeLayout& layout, const std::vector<bool>& elements, const BarcodeRecord& barcode) {
    if (barcode.isInverted) {
        const double margin = kQuietZone * barcode.elementWidth;
        const double top = barcode.height + barcode.elementWidth;
        addRectangle(layout.bars, {-margin, -1.0 * barcode.elementWidth}, {layout.width + margin, top}, false);
    }
    double at = 0.0;
    for (std::size_t i = 0; i < elements.size(); ++i) {
        const double next = at + (elements[i] ? kWide : 1.0) * barcode.elementWidth;
        if (i % 2 == 0) {
            addRectangle(layout.bars, {at, 0.0}, {next, 1.0 * barcode.height}, barcode.isInverted);
        }
        at = next;
    }
}

double widthOf(const std::vector<bool>& elements, double narrow) {
    const auto wide = static_cast<double>(std::ranges::count(elements, true));
    return narrow * (static_cast<double>(elements.size()) + (kWide - 1.0) * wide);
}

/// A frame as wide as a narrow element around the space of as many characters.
void addFrame(BarcodeLayout& layout, const BarcodeRecord& barcode) {
    // A character is 6 narrow and 3 wide elements and a narrow space: 16 narrow ones. The last one has no space.
    layout.width = barcode.elementWidth * (16.0 * (static_cast<double>(barcode.text.size()) + 2) - 1);
    const double line = barcode.elementWidth;
    const double height = barcode.height;
    addRectangle(layout.bars, {0.0, 0.0}, {layout.width, height}, false);
    if (height > 2 * line) {
        addRectangle(layout.bars, {line, line}, {layout.width - line, height - line}, true);
    }
}

void addString(BarcodeLayout& layout, const BarcodeRecord& barcode, const formats::Font& font) {
    const formats::TextLine line{barcode.text, static_cast<Nm>(kStringSize), static_cast<Nm>(kStringSize),
                                 kStringFactor};
    const formats::TextLayout text = layOut(line, font);
    const double x = (layout.width - text.length) / 2;
    const double y = barcode.isStringAbove ? barcode.height + kStringGap : -kStringGap - kStringSize;
    for (formats::TextStroke stroke : text.strokes) {
        stroke.a = {stroke.a.x + x, stroke.a.y + y};
        stroke.b = {stroke.b.x + x, stroke.b.y + y};
        layout.string.push_back(stroke);
    }
    layout.problem += layout.problem.empty() ? text.problem : "";
}

}  // namespace

std::vector<bool> code39(std::string_view text, bool isFullAscii, bool hasChecksum) {
    std::optional<std::string> characters = encoded(text, isFullAscii);
    if (!characters) {
        return {};
    }
    if (hasChecksum) {
        std::size_t sum = 0;
        for (const char c : *characters) {
            sum += kCharacters.find(c);
        }
        *characters += kCharacters[sum % kChecked];
    }
    std::vector<bool> elements;
    for (const char c : "*" + *characters + "*") {
        if (!elements.empty()) {
            elements.push_back(false);  // the space between characters
        }
        for (const char width : kPatterns[kCharacters.find(c)]) {
            elements.push_back(width == 'w');
        }
    }
    return elements;
}

BarcodeLayout layOut(const BarcodeRecord& barcode, const formats::Font& font) {
    BarcodeLayout layout;
    // Two code 39 characters of 16 narrow elements per letter at most, and start, stop and checksum.
    if (barcode.elementWidth * 32.0 * (static_cast<double>(barcode.text.size()) + 3) > base::kMaxCoordinate / 2.0 ||
        barcode.height > base::kMaxCoordinate / 2) {
        layout.problem = "the barcode is larger than half a metre; it draws nothing";
        return layout;
    }
    const bool isKnown = equalsIgnoringCase(barcode.code, "UPC39");
    const std::vector<bool> elements =
        isKnown ? code39(barcode.text, barcode.isFullAscii, barcode.hasChecksum) : std::vector<bool>();
    if (!elements.empty()) {
        layout.width = widthOf(elements, barcode.elementWidth);
        addBars(layout, elements, barcode);
    } else {
        layout.problem = isKnown
                             ? "code 39 cannot hold the text '" + barcode.text + "'; a frame stands for the barcode"
                             : "barcodes of kind " + barcode.code + " are not known; a frame stands for the barcode";
        addFrame(layout, barcode);
    }
    if (barcode.hasString) {
        addString(layout, barcode, font);
    }
    return layout;
}

}  // namespace model::odb
