#include "model/nets/net_statistics.h"

#include <algorithm>
#include <numeric>

#include "model/base/ascii.h"
#include "model/base/parallel.h"
#include "model/statistics/element_sizes.h"

namespace model {

namespace {

constexpr std::size_t kPiece = 256;  // nets per task

/// Takes a run of digits off the front, without leading zeros.
std::string_view takeNumber(std::string_view& text) {
    std::size_t end = 0;
    while (end < text.size() && base::isDigit(text[end])) {
        ++end;
    }
    std::string_view number = text.substr(0, end);
    text.remove_prefix(end);
    number.remove_prefix(std::min(number.find_first_not_of('0'), number.size()));
    return number;
}

/// How long the part is that both begin with, up to a number: names of a board, and lists of attributes, are much
/// alike.
std::size_t commonPrefix(std::string_view a, std::string_view b) {
    auto size = static_cast<std::size_t>(std::ranges::mismatch(a, b).in1 - a.begin());
    while (size > 0 && base::isDigit(a[size - 1])) {
        --size;
    }
    return size;
}

/// Negative, 0 or positive as in strcmp.
int compareNames(std::string_view a, std::string_view b) {
    const std::size_t alike = commonPrefix(a, b);
    a.remove_prefix(alike);
    b.remove_prefix(alike);
    while (!a.empty() && !b.empty()) {
        if (base::isDigit(a.front()) && base::isDigit(b.front())) {
            const std::string_view m = takeNumber(a);
            const std::string_view n = takeNumber(b);
            if (m.size() != n.size()) {
                return m.size() < n.size() ? -1 : 1;
            }
            if (const int order = m.compare(n); order != 0) {
                return order;
            }
            continue;
        }
        if (base::lowerAscii(a.front()) != base::lowerAscii(b.front())) {
            return base::lowerAscii(a.front()) < base::lowerAscii(b.front()) ? -1 : 1;
        }
        a.remove_prefix(1);
        b.remove_prefix(1);
    }
    return a.empty() ? (b.empty() ? 0 : -1) : 1;
}

bool isRouted(const Document& document, ElementId element) {
    return document.layer(document.elements.layer[element.row()]).isCopper() &&
           (document.elements.flags[element.row()] & (kPad | kHole)) == 0;
}

void measure(const Document& document, NetId net, NetStatistics& out) {
    const std::size_t row = net.row();
    for (const ElementId element : document.elementsOf(net)) {
        const bool isHole = (document.elements.flags[element.row()] & kHole) != 0;
        if (!isHole && document.layer(document.elements.layer[element.row()]).isCopper()) {
            out.areaNm2[row] += areaOf(document, element);
            out.lengthNm[row] += isRouted(document, element) ? lengthOf(document, element) : 0.0;
        }
    }
}

}  // namespace

std::vector<std::uint32_t> pinCounts(const Document& document) {
    std::vector<std::uint32_t> counts(document.nets.size());
    for (const Pin& pin : document.pins) {
        if (pin.net.isValid()) {
            ++counts[pin.net.row()];
        }
    }
    return counts;
}

std::vector<std::uint32_t> viaCounts(const Document& document) {
    std::vector<std::uint32_t> counts(document.nets.size());
    for (std::size_t row = 0; row < document.elements.size(); ++row) {
        const NetId net = document.elements.net[row];
        const std::uint8_t flags = document.elements.flags[row];
        if (net.isValid() && (flags & kHole) != 0 && holeKind(flags) == HoleKind::Via) {
            ++counts[net.row()];
        }
    }
    return counts;
}

std::vector<std::uint32_t> ranksOf(std::span<const std::string> names) {
    std::vector<std::uint32_t> order(names.size());
    std::iota(order.begin(), order.end(), 0U);
    std::ranges::stable_sort(order, [&](auto a, auto b) { return isNamedBefore(names[a], names[b]); });
    std::vector<std::uint32_t> ranks(names.size());
    for (std::uint32_t rank = 0; rank < order.size(); ++rank) {
        ranks[order[rank]] = rank;
    }
    return ranks;
}

bool isNamedBefore(std::string_view a, std::string_view b) {
    const int order = compareNames(a, b);
    return order != 0 ? order < 0 : a < b;
}

base::Result<NetStatistics> measureNets(const Document& document, base::Progress& progress) {
    progress.beginPhase("Measuring nets");
    const std::size_t count = document.nets.size();
    NetStatistics out;
    out.pins = pinCounts(document);
    out.vias = viaCounts(document);
    out.lengthNm.resize(count);
    out.areaNm2.resize(count);
    base::parallelFor((count + kPiece - 1) / kPiece, [&](std::size_t piece) {
        for (std::size_t row = piece * kPiece; row < std::min(count, (piece + 1) * kPiece); ++row) {
            if (!progress.isCancelled()) {
                measure(document, NetId{row}, out);
            }
        }
    });
    if (progress.isCancelled()) {
        return base::Error{base::ErrorCode::Cancelled, "Cancelled"};
    }
    std::vector<std::string> names;
    std::ranges::transform(document.nets, std::back_inserter(names), &Net::name);
    out.nameRank = ranksOf(names);
    return out;
}

std::vector<std::pair<LayerId, double>> routedLengths(const Document& document, NetId net) {
    std::vector<double> perLayer(document.layers.size());
    for (const ElementId element : document.elementsOf(net)) {
        if (isRouted(document, element)) {
            perLayer[document.elements.layer[element.row()].row()] += lengthOf(document, element);
        }
    }
    std::vector<std::pair<LayerId, double>> lengths;
    for (std::size_t row = 0; row < perLayer.size(); ++row) {
        if (perLayer[row] > 0.0) {
            lengths.emplace_back(LayerId{row}, perLayer[row]);
        }
    }
    return lengths;
}

}  // namespace model
