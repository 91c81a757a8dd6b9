#include "model/formats/ipc2581/reading.h"

#include <algorithm>
#include <cmath>

#include "model/formats/ipc2581/xml/xml_values.h"

namespace model::ipc2581 {

namespace {

/// Beyond the coordinate range, but far from what doubles and 64-bit integers overflow at.
constexpr double kFar = 4.0 * base::kMaxCoordinate;
/// More names of unknown elements than this are not told apart.
constexpr std::size_t kMostNames = 40;
constexpr std::size_t kLongestName = 60;

}  // namespace

void Reading::reportUnknown(const XmlCursor& at) {
    std::string name = textOf(at.name().substr(0, kLongestName));
    const bool isNamed = m_unknown.contains(name) || m_unknown.size() < kMostNames;
    report(Severity::Info, at.line(),
           isNamed ? "element " + name + " is of no kind that is read here; it was left out"
                   : "elements of further kinds that are not read were left out");
    if (isNamed) {
        m_unknown.insert(std::move(name));
    }
}

double Reading::length(const XmlCursor& at, std::string_view attribute, double unitNm) {
    const std::optional<double> value = realOf(at.value(attribute));
    if (!value) {
        report(Severity::Warning, at.line(),
               "attribute " + std::string(attribute) + " is missing or no number; 0 is used");
        return 0.0;
    }
    return std::clamp(*value * unitNm, -kFar, kFar);
}

double Reading::lengthOr(const XmlCursor& at, std::string_view attribute, double unitNm, double otherwise) {
    return at.value(attribute).empty() ? otherwise : length(at, attribute, unitNm);
}

Point Reading::rounded(PointD p, std::uint32_t line) {
    constexpr double kMost = base::kMaxCoordinate;
    if (!(std::abs(p.x) <= kMost && std::abs(p.y) <= kMost)) {
        report(Severity::Error, line, "a coordinate lies more than 1.07 m from the origin; it is moved there");
        p = {std::clamp(p.x, -kMost, kMost), std::clamp(p.y, -kMost, kMost)};
    }
    return {static_cast<Nm>(std::llround(p.x)), static_cast<Nm>(std::llround(p.y))};
}

double unitNamed(std::string_view name) {
    if (name == "MILLIMETER" || name == "MM" || name == "MILLIMETERS") {
        return base::kNmPerMm;
    }
    if (name == "INCH" || name == "INCHES" || name == "IN") {
        return base::kNmPerInch;
    }
    if (name == "MICRON" || name == "MICRONS" || name == "UM") {
        return base::kNmPerUm;
    }
    return name == "MIL" || name == "MILS" ? base::kNmPerMil : 0.0;
}

bool readTurn(Reading& reading, const XmlCursor& at, double unitNm, Turn& turn) {
    const bool isXform = at.name() == "Xform";
    if (!isXform && at.name() != "Location") {
        return false;
    }
    turn.origin.x += reading.lengthOr(at, "x", unitNm, 0.0);
    turn.origin.y += reading.lengthOr(at, "y", unitNm, 0.0);
    if (!isXform) {
        return true;
    }
    turn.origin.x += reading.lengthOr(at, "xOffset", unitNm, 0.0);
    turn.origin.y += reading.lengthOr(at, "yOffset", unitNm, 0.0);
    turn.ccwDeg = normalDegrees(reading.lengthOr(at, "rotation", 1.0, 0.0));
    turn.isMirrored = isTrue(at.value("mirror"));
    if (isTrue(at.value("faceUp"))) {
        reading.report(Severity::Info, at.line(), "whether embedded parts lie face up (faceUp) is not read");
    }
    const double scale = reading.lengthOr(at, "scale", 1.0, 1.0);
    constexpr double kMostScale = 1000.0;
    if (scale > 0.0 && scale <= kMostScale) {
        turn.scale = scale;
    } else {
        reading.report(Severity::Warning, at.line(), "an Xform with an absurd scale; 1 is used");
    }
    return true;
}

}  // namespace model::ipc2581
