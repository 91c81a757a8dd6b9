#include "model/formats/kicad/canvas.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "model/formats/kicad/text/values.h"
#include "model/text/number_text.h"

namespace model::kicad {

using formats::DrawnFeature;
using formats::DrawnKind;
using formats::kNoRow;

PointD Frame::apply(PointD local) const {
    const double turns = degrees / 90.0;
    if (turns == std::floor(turns) && std::abs(turns) < 1e6) {  // stay on the grid
        constexpr std::array<double, 4> kCosines = {1.0, 0.0, -1.0, 0.0};
        const auto quarter = static_cast<std::size_t>(static_cast<std::int64_t>(turns) & 3);
        const double cosine = kCosines[quarter];
        const double sine = kCosines[(quarter + 3) % 4];
        return {origin.x + local.x * cosine - local.y * sine, origin.y + local.x * sine + local.y * cosine};
    }
    const double sine = std::sin(degrees * std::numbers::pi / 180.0);
    const double cosine = std::cos(degrees * std::numbers::pi / 180.0);
    return {origin.x + local.x * cosine - local.y * sine, origin.y + local.x * sine + local.y * cosine};
}

Nm asNm(double length) {
    constexpr double kMost = base::kMaxCoordinate;
    return static_cast<Nm>(std::llround(std::clamp(length, -kMost, kMost)));
}

Canvas::Canvas(formats::DrawnJob& job, std::string_view file) : m_job(job), m_file(file) {
    m_job.steps.resize(1);
    m_job.steps[0].name = "pcb";
    m_job.steps[0].profileFile = file;
}

void Canvas::report(Severity severity, std::uint32_t line, std::string_view text) {
    m_job.diagnostics.report(severity, m_file, line, text);
}

void Canvas::reportNotDrawn(const Item& item) {
    report(Severity::Info, item.line(),
           "items of the kind '" + std::string(item.head().substr(0, 40)) + "' are not drawn");
}

void Canvas::reportVariants(const Item& item) {
    const bool isEmpty = std::ranges::none_of(item, &Item::isList);
    if (!isEmpty) {
        report(Severity::Info, item.line(), "variants are not read; what is shown and populated is the base design");
    }
}

// ---- nets ----

std::int32_t Canvas::netNamed(std::string_view name) {
    if (name.empty()) {
        return kNoRow;
    }
    const auto [found, isNew] =
        m_netOfName.try_emplace(std::string(name), static_cast<std::int32_t>(step().nets.size()));
    if (isNew) {
        step().nets.push_back({std::string(name), {}});
    }
    return found->second;
}

void Canvas::declareNet(const Item& net) {
    const std::optional<double> number = numberOf(net.word(1));
    if (number && std::abs(*number) < 1e15) {
        m_netOfNumber[static_cast<std::int64_t>(*number)] = netNamed(net.text(2));
    }
}

std::int32_t Canvas::netOf(const Item& item) {
    const Item net = item.find("net");
    const Item first = net.at(1);
    if (!net.isThere() || first.isList()) {
        return kNoRow;
    }
    const std::optional<double> number = first.isQuoted() ? std::nullopt : numberOf(first.source());
    if (!number || std::abs(*number) > 1e15) {
        return netNamed(net.text(1));
    }
    const auto known = m_netOfNumber.find(static_cast<std::int64_t>(*number));
    if (known != m_netOfNumber.end()) {
        return known->second;
    }
    const std::string name = net.text(2);
    if (name.empty() && *number != 0.0) {
        report(Severity::Warning, net.line(), "the number of a net is not in the list of nets; the item has no net");
    }
    return netNamed(name);
}

// ---- drawing ----

std::vector<std::int32_t> Canvas::rowsOf(const Item& item) {
    Item names = item.find("layer");
    names = names.isThere() ? names : item.find("layers");
    std::vector<std::int32_t> rows = m_layers.rows(names);
    if (rows.empty()) {
        report(Severity::Info, item.line(), "an item lies on no layer that the board has; it was left out");
    }
    return rows;
}

std::optional<Point> Canvas::onGrid(PointD p, std::uint32_t line) {
    constexpr double kMost = base::kMaxCoordinate;
    if (!(std::abs(p.x) <= kMost && std::abs(p.y) <= kMost)) {
        report(Severity::Error, line, "an item lies outside of the coordinate range of ±1.07 m; it was left out");
        return {};
    }
    return Point{static_cast<Nm>(std::llround(p.x)), static_cast<Nm>(std::llround(p.y))};
}

std::int32_t Canvas::pen(double width) {
    const Nm size = asNm(width);
    const auto [found, isNew] = m_pens.try_emplace(size, static_cast<std::int32_t>(step().symbols.size()));
    if (isNew) {
        std::string name = "r";
        appendNumber(name, size / base::kNmPerUm, 3);
        formats::PadShape shape;
        shape.kind = formats::PadShape::Kind::Round;
        shape.width = size;
        shape.height = size;
        step().symbols.push_back({std::move(name), std::move(shape)});
    }
    return found->second;
}

std::int32_t Canvas::symbol(const std::string& key, formats::PadShape shape) {
    if (shape.kind == formats::PadShape::Kind::Round) {
        return pen(shape.width);
    }
    const auto [found, isNew] = m_symbols.try_emplace(key, static_cast<std::int32_t>(step().symbols.size()));
    if (isNew) {
        const bool isCustom = key.starts_with("custom");
        step().symbols.push_back({isCustom ? "custom " + std::to_string(found->second + 1) : key, std::move(shape)});
    }
    return found->second;
}

std::int32_t Canvas::attributes(const formats::Words& words) {
    if (words.empty()) {
        return kNoRow;
    }
    const auto [found, isNew] = m_attributes.try_emplace(words, static_cast<std::int32_t>(step().attributes.size()));
    if (isNew) {
        step().attributes.push_back(words);
    }
    return found->second;
}

DrawnFeature& Canvas::add(std::int32_t row, const Origin& origin, DrawnKind kind) {
    if (step().features.size() < m_job.layers.size()) {
        step().features.resize(m_job.layers.size());
    }
    DrawnFeature& feature = step().features[static_cast<std::size_t>(row)].emplace_back();
    const bool hasNet = m_layers.isCopper(row) || m_job.layers[static_cast<std::size_t>(row)].type == LayerType::Drill;
    feature.kind = kind;
    feature.line = origin.line;
    feature.net = hasNet ? origin.net : kNoRow;
    feature.component = hasNet && origin.pin != kNoRow ? origin.component : kNoRow;
    feature.pin = hasNet ? origin.pin : kNoRow;
    feature.attributes = origin.attributes;
    feature.subnet = origin.subnet;
    feature.plating = origin.plating;
    return feature;
}

std::uint32_t Canvas::drawnOn(std::int32_t row) {
    const auto index = static_cast<std::size_t>(row);
    return index < step().features.size() ? static_cast<std::uint32_t>(step().features[index].size()) : 0;
}

void Canvas::drawEdge(std::int32_t row, const Origin& origin, const PathNode& from, Point to, double width) {
    const std::int32_t symbol = pen(width);
    DrawnFeature& feature = add(row, origin, isArc(from.edge) ? DrawnKind::Arc : DrawnKind::Line);
    feature.symbol = symbol;
    feature.a = from.point;
    feature.b = to;
    feature.centre = from.centre;
    feature.isClockwise = from.edge == EdgeKind::ArcClockwise;
}

void Canvas::drawPad(std::int32_t row, const Origin& origin, std::int32_t symbol, PointD at, double clockwiseDeg) {
    const std::optional<Point> place = onGrid(at, origin.line);
    if (!place) {
        return;
    }
    DrawnFeature& feature = add(row, origin, DrawnKind::Pad);
    feature.symbol = symbol;
    feature.a = *place;
    feature.clockwiseDeg = clockwiseDeg;
}

void Canvas::drawRegion(std::int32_t row, const Origin& origin, ShapeSketch region) {
    if (region.isEmpty()) {
        return;
    }
    const auto index = static_cast<std::int32_t>(step().regions.size());
    step().regions.push_back(std::move(region));
    add(row, origin, DrawnKind::Region).region = index;
}

}  // namespace model::kicad
