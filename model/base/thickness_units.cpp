#include "model/base/thickness_units.h"

#include <charconv>
#include <cmath>
#include <cstdio>
#include <utility>

#include "model/base/ascii.h"

namespace model {

using base::Error;
using base::ErrorCode;

namespace {

struct LengthUnit {
    std::string_view name;
    double nm = 0.0;
    bool isWeight = false;
};

constexpr double kLongest = 1e9;  ///< nm

constexpr LengthUnit kUnits[] = {{"um", base::kNmPerUm},         {"µm", base::kNmPerUm},   {"μm", base::kNmPerUm},
                                 {"mm", base::kNmPerMm},         {"mil", base::kNmPerMil}, {"mils", base::kNmPerMil},
                                 {"inch", base::kNmPerInch},     {"in", base::kNmPerInch}, {"\"", base::kNmPerInch},
                                 {"oz", base::kNmPerOunce, true}};

std::string_view trimmed(std::string_view text) {
    const std::size_t first = text.find_first_not_of(" \t");
    return first == std::string_view::npos ? "" : text.substr(first, text.find_last_not_of(" \t") - first + 1);
}

Error wrong(std::string_view text, const std::string& why) {
    return {ErrorCode::BadUsage, "\"" + std::string(text) + "\" " + why};
}

const LengthUnit* findUnit(std::string_view name) {
    for (const LengthUnit& unit : kUnits) {
        if (unit.name == name) {
            return &unit;
        }
    }
    return nullptr;
}

/// No unit: the text is not a number with one.
std::pair<double, const LengthUnit*> numberAndUnit(std::string_view text) {
    const std::string point = withDecimalPoint(text);
    const std::string_view whole = trimmed(point);
    double value = 0.0;
    const auto number = std::from_chars(whole.data(), whole.data() + whole.size(), value);
    const std::string_view rest = trimmed(whole.substr(static_cast<std::size_t>(number.ptr - whole.data())));
    return {value, number.ec == std::errc() ? findUnit(rest) : nullptr};
}

}  // namespace

std::string withDecimalPoint(std::string_view text) {
    std::string out(text);
    const std::size_t comma = out.find(',');
    const bool isAlone =
        comma != std::string::npos && out.find_first_of(".,", comma + 1) == std::string::npos && out.find('.') > comma;
    if (!isAlone || comma == 0 || !base::isDigit(out[comma - 1])) {
        return out;
    }
    std::size_t end = comma + 1;
    while (end < out.size() && base::isDigit(out[end])) {
        ++end;
    }
    std::size_t begin = comma;
    while (begin > 0 && base::isDigit(out[begin - 1])) {
        --begin;
    }
    const std::size_t behind = end - comma - 1;
    const bool mayBeThousands = behind == 3 && out[begin] != '0' && comma - begin <= 3;
    if (behind > 0 && !mayBeThousands) {
        out[comma] = '.';
    }
    return out;
}

base::Result<Nm> parseLength(std::string_view text) {
    const auto [value, unit] = numberAndUnit(text);
    if (unit == nullptr || unit->isWeight) {
        return wrong(text, "is no length; write a number with um, mm, mil or inch: 100um, 0.2mm, 5mil");
    }
    const double nm = value * unit->nm;
    if (!(nm > 0.0 && nm <= kLongest)) {
        return wrong(text, "is outside of what can be measured on a board: above 0 to 1 m");
    }
    return static_cast<Nm>(std::llround(nm));
}

base::Result<Nm> parseThickness(std::string_view text, bool isCopper) {
    const auto [value, unit] = numberAndUnit(text);
    if (unit == nullptr) {
        return wrong(text,
                     "is no thickness; write a number with um, mm, mil or inch, or oz for copper: 35um, 0.2mm, 1oz");
    }
    if (unit->isWeight && !isCopper) {
        return wrong(text, "is a weight of copper, but the layer is not copper");
    }
    const double nm = value * unit->nm;
    if (!(nm >= kLeastSet && nm <= kMostSet)) {
        return wrong(text, "is outside of what a layer can be: 1 µm to 10 mm");
    }
    return static_cast<Nm>(std::llround(nm));
}

std::string thicknessText(Nm thickness) {
    const bool isMm = thickness >= 1'000'000;
    char number[32];
    std::snprintf(number, sizeof number, "%.*f", isMm ? 6 : 3, thickness / (isMm ? base::kNmPerMm : base::kNmPerUm));
    std::string text = number;
    text.erase(text.find_last_not_of('0') + 1);
    text.erase(text.find_last_not_of('.') + 1);
    return text + (isMm ? " mm" : " µm");
}

}  // namespace model
