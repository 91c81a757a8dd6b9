#include "model/measure/measurement.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "model/base/units.h"
#include "model/measure/edge_at.h"
#include "model/text/formatting.h"

namespace model {

namespace {

constexpr std::array<const char*, 7> kKindNames = {"point to point", "edge to edge", "spacing at a location", "angle",
                                                   "radius",         "along a net",  "annular ring"};

std::string mm(double nm) {
    return fixedText(base::toMm(nm), 6);
}

std::string mil(double nm) {
    return fixedText(nm / base::kNmPerMil, 4);
}

/// "TOP 1.500000; 2 holes 3.000000"
std::string partsOf(const MeasuredPath& path) {
    std::string parts;
    for (const auto& [layer, length] : path.perLayer()) {
        parts += layer + " " + mm(length) + "; ";
    }
    return parts + std::to_string(path.holeCount) + " holes " + mm(path.holeHeight);
}

std::vector<std::string> cellsOf(const Measurement& m) {
    const bool isLength = m.path.has_value();
    const bool isAngle = m.kind == MeasurementKind::Angle;
    const double value = isLength ? m.path->length() : m.value();
    return {m.name,
            m.step,
            toString(m.kind),
            isAngle ? "" : mm(value),
            isAngle ? "" : mil(value),
            isAngle ? fixedText(m.angleDeg(), 4) : "",
            mm(m.dx()),
            mm(m.dy()),
            mm(m.dz),
            mm(m.overlap),
            m.from.layer,
            m.to.layer,
            m.from.net,
            m.to.net,
            mm(m.from.x),
            mm(m.from.y),
            mm(m.to.x),
            mm(m.to.y),
            m.corner ? mm(m.corner->x) : "",
            m.corner ? mm(m.corner->y) : "",
            isLength ? partsOf(*m.path) : "",
            joined(m.notes, "; "),
            m.from.item,
            m.to.item};
}

}  // namespace

const char* toString(MeasurementKind kind) {
    return kKindNames[static_cast<std::size_t>(kind)];
}

std::optional<MeasurementKind> kindNamed(const std::string& name) {
    const auto* const at = std::ranges::find(kKindNames, name);
    return at == kKindNames.end() ? std::nullopt : std::optional(static_cast<MeasurementKind>(at - kKindNames.begin()));
}

double MeasuredPath::length() const {
    double sum = holeHeight;
    for (const MeasuredRun& run : runs) {
        sum += run.length;
    }
    return sum;
}

std::vector<std::pair<std::string, double>> MeasuredPath::perLayer() const {
    std::vector<std::pair<std::string, double>> layers;
    for (const MeasuredRun& run : runs) {
        auto at = std::ranges::find(layers, run.layer, &std::pair<std::string, double>::first);
        if (at == layers.end()) {
            at = layers.insert(at, {run.layer, 0.0});
        }
        at->second += run.length;
    }
    return layers;
}

double Measurement::distance() const {
    return std::hypot(dx(), dy(), dz);
}

double Measurement::value() const {
    return isPlanar ? std::hypot(dx(), dy()) : distance();
}

double Measurement::angleDeg() const {
    return corner ? model::angleDeg({from.x - corner->x, from.y - corner->y}, {to.x - corner->x, to.y - corner->y})
                  : 0.0;
}

std::string measurementsCsv(const std::vector<Measurement>& measurements) {
    std::string csv =
        "name,step,kind,value mm,value mil,value deg,dx mm,dy mm,dz mm,overlap mm,layer a,layer b,net a,net b,"
        "x mm on a,y mm on a,x mm on b,y mm on b,x mm at corner,y mm at corner,parts mm,notes,element a,element b\n";
    for (const Measurement& m : measurements) {
        for (const std::string& cell : cellsOf(m)) {
            csv += csvField(cell) + ",";
        }
        csv.back() = '\n';
    }
    return csv;
}

}  // namespace model
