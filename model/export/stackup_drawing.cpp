#include "model/export/stackup_drawing.h"

#include <algorithm>
#include <cmath>
#include <string_view>

#include "model/board/stackup.h"
#include "model/text/formatting.h"

namespace model {

namespace {

constexpr double kMostTimes = 40.0;
/// With zones: the part of the width that the holes take, and what is left free beside each zone.
constexpr double kBoresBesideZones = 0.25;
constexpr double kBesideZone = 0.02;

double copperTimes(const std::vector<StackupRow>& rows) {
    double copper = 0.0;
    double substrate = 0.0;
    for (const StackupRow& row : rows) {
        copper += isCopper(row) ? row.thickness : 0.0;
        substrate += row.type == LayerType::Dielectric ? row.thickness : 0.0;
    }
    return copper > 0.0 ? std::clamp(std::round(substrate / copper), 1.0, kMostTimes) : 1.0;
}

void placeBands(const std::vector<StackupRow>& rows, StackupDrawing& out) {
    const auto weight = [&](const StackupRow& row) { return row.thickness * (isCopper(row) ? out.copperTimes : 1.0); };
    double all = 0.0;
    for (const StackupRow& row : rows) {
        all += weight(row);
    }
    double y = 0.0;
    for (const StackupRow& row : rows) {
        const double high = all > 0.0 ? weight(row) / all * out.height : 0.0;
        out.bands.push_back({y, y + high, y + high / 2});
        y += high;
    }
}

const StackupBand* bandOf(const Document& document, const StackupDrawing& drawing, LayerId layer) {
    const auto& rows = document.stackup.rows;
    const auto row = std::ranges::find(rows, layer, &StackupRow::layer);
    return layer.isValid() && row != rows.end() ? &drawing.bands[static_cast<std::size_t>(row - rows.begin())]
                                                : nullptr;
}

void addHoles(const DrillRow& row, StackupBarrel& bore) {
    bore.count += row.count;
    if (hasDrilledSize(row)) {
        bore.least = bore.least == 0 ? row.diameter : std::min(bore.least, row.diameter);
        bore.most = std::max(bore.most, row.diameter);
    }
}

/// A line for a router that says where and not how wide, as outlines of boards are drawn, is no hole in the stack.
bool isLineAlone(const DrillRow& row) {
    return row.shape == std::string_view("path") && row.diameter == 0;
}

/// Holes through the only copper layer pass what it lies on, too.
void passSubstrate(const Document& document, const StackupDrawing& drawing, StackupBarrel& bore) {
    const auto& rows = document.stackup.rows;
    const auto copper = std::ranges::find(rows, document.layer(bore.layer).spanTop, &StackupRow::layer);
    const SubstrateRows substrate = substrateOf(rows, static_cast<std::size_t>(copper - rows.begin()));
    for (std::size_t row = substrate.first; row < substrate.end; ++row) {
        bore.top = std::min(bore.top, drawing.bands[row].top);
        bore.bottom = std::max(bore.bottom, drawing.bands[row].bottom);
    }
}

void placeBores(const Document& document, StackupDrawing& out) {
    for (const DrillRow& row : drillTableWithCopies(document)) {
        if (isLineAlone(row)) {
            continue;
        }
        const bool isPlated = row.kind != HoleKind::NonPlated;
        const auto same = std::ranges::find_if(out.bores, [&](const StackupBarrel& bore) {
            return bore.layer == row.layer && bore.span == row.span && bore.isPlated == isPlated;
        });
        if (same != out.bores.end()) {
            addHoles(row, *same);
            continue;
        }
        const Layer& layer = document.layer(row.layer);
        const StackupBand* first = bandOf(document, out, layer.spanTop);
        const StackupBand* last = bandOf(document, out, layer.spanBottom);
        if (first != nullptr && last != nullptr) {
            out.bores.push_back({row.layer, row.span, isPlated, first->top, last->bottom});
            addHoles(row, out.bores.back());
            if (first == last && row.span == HoleSpan::Through) {
                passSubstrate(document, out, out.bores.back());
            }
        }
    }
}

void placeColumns(const Document& document, StackupDrawing& out) {
    std::vector<Substack> parts = substacksOf(document);
    const auto count = static_cast<double>(parts.size());
    const bool isWhole = document.zones.empty();
    const double right = isWhole || out.bores.empty() ? 1.0 : 1.0 - kBoresBesideZones;
    for (Substack& part : parts) {
        const auto number = static_cast<double>(out.columns.size());
        out.columns.push_back({std::move(part), right * number / count, right * (number + 1) / count});
        out.columns.back().right -= isWhole ? 0.0 : kBesideZone;
    }
    const double left = isWhole ? 0.0 : right;
    const double breadth = (1.0 - left) / std::max(1.0, static_cast<double>(out.bores.size()));
    for (std::size_t i = 0; i < out.bores.size(); ++i) {
        out.bores[i].breadth = breadth;
        out.bores[i].x = left + breadth * (static_cast<double>(i) + 0.5);
    }
}

std::string sizesText(const StackupBarrel& bore, const LengthWriter& write) {
    if (bore.most == 0) {
        return "";
    }
    if (write) {
        const std::string least = write(bore.least);
        const std::string number = least.substr(0, least.find(' '));  // the unit is said once
        return " of " + (bore.least == bore.most ? "" : number + " to ") + write(bore.most);
    }
    return bore.least == bore.most ? formatted(" of %.4g mm", base::toMm(bore.most))
                                   : formatted(" of %.4g to %.4g mm", base::toMm(bore.least), base::toMm(bore.most));
}

}  // namespace

/// Down where they overlap, then up again from the lower edge.
void spreadLabels(double lineHeight, StackupDrawing& out) {
    double free = lineHeight / 2;
    for (StackupBand& band : out.bands) {
        band.label = std::max(band.label, free);
        free = band.label + lineHeight;
    }
    double last = out.height - lineHeight / 2;
    for (auto band = out.bands.rbegin(); band != out.bands.rend(); ++band) {
        band->label = std::min(band->label, last);
        last = band->label - lineHeight;
    }
}

StackupDrawing drawStackup(const Document& document, const StackupLayout& layout) {
    const std::vector<StackupRow>& rows = document.stackup.rows;
    StackupDrawing out;
    if (rows.empty()) {
        return out;
    }
    out.height = std::max(layout.height, layout.lineHeight * static_cast<double>(rows.size()));
    out.copperTimes = layout.isExaggerated ? copperTimes(rows) : 1.0;
    placeBands(rows, out);
    spreadLabels(layout.lineHeight, out);
    placeBores(document, out);
    placeColumns(document, out);
    return out;
}

std::string boreText(const Document& document, const StackupBarrel& bore, const LengthWriter& write) {
    return document.layer(bore.layer).name + ": " + toString(bore.span) +
           (bore.isPlated ? ", plated, " : ", non-plated, ") + std::to_string(bore.count) +
           (bore.count == 1 ? " hole" : " holes") + sizesText(bore, write);
}

}  // namespace model
