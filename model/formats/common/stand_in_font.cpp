// The font that stands in where a file does not bring its own.
#include <array>
#include <cstddef>
#include <string_view>

#include "model/formats/common/font.h"

namespace model::formats {

namespace {

/// Characters from space to tilde. Two digits are a point: x from 0 to 4, y from 0 to 8 with the base line at 2 and
/// capitals up to 8. Points are joined to a line, a blank begins the next one, a lone point is a dot.
constexpr std::array<std::string_view, 95> kGlyphs = {
    "",                                  // space
    "2824 22",                           // !
    "1816 3836",                         // "
    "1317 3337 0646 0444",               // #
    "473818070615354443321203 2921",     // $
    "0248 0708181707 3343423233",        // %
    "42070818172603123244",              // &
    "2826",                              // '
    "38262432",                          // (
    "18262412",                          // )
    "2723 0446 0644",                    // *
    "2723 0545",                         // +
    "231211",                            // ,
    "0545",                              // -
    "22",                                // .
    "0248",                              // /
    "123243473818070312 0347",           // 0
    "072822 1232",                       // 1
    "07183847460242",                    // 2
    "0818384746354443321203 1535",       // 3
    "380444 3832",                       // 4
    "480805354443321203",                // 5
    "38180703123243443505",              // 6
    "084822",                            // 7
    "15060718384746351504031232434435",  // 8
    "12324347381807061545",              // 9
    "26 23",                             // :
    "26 231211",                         // ;
    "470543",                            // <
    "0646 0444",                         // =
    "074503",                            // >
    "07183847462524 22",                 // ?
    "4232120307183847442436",            // @
    "0206284642 0444",                   // A
    "02083847463505 3544433202",         // B
    "4738180703123243",                  // C
    "02082846442202",                    // D
    "48080242 0535",                     // E
    "480802 0535",                       // F
    "47381807031232434525",              // G
    "0208 4248 0545",                    // H
    "2228 1232 1838",                    // I
    "0312324348",                        // J
    "0208 480542",                       // K
    "080242",                            // L
    "0208254842",                        // M
    "02084248",                          // N
    "123243473818070312",                // O
    "02083847463505",                    // P
    "123243473818070312 2442",           // Q
    "02083847463505 2542",               // R
    "473818070615354443321203",          // S
    "2228 0848",                         // T
    "080312324348",                      // U
    "082248",                            // V
    "0812253248",                        // W
    "0248 0842",                         // X
    "082548 2522",                       // Y
    "08480242",                          // Z
    "38282232",                          // [
    "0842",                              // backslash
    "18282212",                          // ]
    "062846",                            // ^
    "0141",                              // _
    "1826",                              // `
    "16364542 441403123243",             // a
    "0802 0312324345361605",             // b
    "4536160503123243",                  // c
    "4842 4332120305163645",             // d
    "044445361605031232",                // e
    "22273848 1636",                     // f
    "4641301001 4332120305163645",       // g
    "0802 0516364542",                   // h
    "2622 28",                           // i
    "36312010 38",                       // j
    "0802 4604 2542",                    // k
    "18282332",                          // l
    "0602 05162522 25364542",            // m
    "0602 0516364542",                   // n
    "123243453616050312",                // o
    "0600 0516364543321203",             // p
    "4640 4536160503123243",             // q
    "0602 05163645",                     // r
    "453616054443321203",                // s
    "28233242 0646",                     // t
    "0603123243 4642",                   // u
    "062246",                            // v
    "0612243246",                        // w
    "0246 0642",                         // x
    "0622 4600",                         // y
    "06460242",                          // z
    "38272615242332",                    // {
    "2820",                              // |
    "18272635242312",                    // }
    "05163445",                          // ~
};

constexpr char32_t kFirst = U' ';
constexpr double kUnit = 0.05;  ///< of the grid, so that capitals are 0.3 tall as in the fonts of real jobs

PointD pointAt(std::string_view line, std::size_t i) {
    return {kUnit * (line[2 * i] - '0'), kUnit * (line[2 * i + 1] - '0')};
}

void addLine(Font& font, char32_t character, std::string_view line) {
    const std::size_t points = line.size() / 2;
    for (std::size_t i = 0; i + 1 < points || (i == 0 && points == 1); ++i) {
        font.addStroke(character, {pointAt(line, i), pointAt(line, points == 1 ? i : i + 1)});
    }
}

Font makeFont() {
    Font font;
    font.setSize(0.302, 0.302, 0.0);
    for (std::size_t i = 0; i < kGlyphs.size(); ++i) {
        const char32_t character = kFirst + static_cast<char32_t>(i);
        font.addCharacter(character);
        std::string_view rest = kGlyphs[i];
        while (!rest.empty()) {
            const std::size_t length = std::min(rest.find(' '), rest.size());
            addLine(font, character, rest.substr(0, length));
            rest.remove_prefix(std::min(length + 1, rest.size()));
        }
    }
    return font;
}

}  // namespace

const Font& standInFont() {
    static const Font font = makeFont();
    return font;
}

}  // namespace model::formats
