#include "model/design_rules/floating_links.h"

#include <algorithm>
#include <optional>
#include <queue>
#include <tuple>

namespace model {

namespace {

std::uint64_t keyOf(std::uint32_t a, std::uint32_t b) {
    const auto [low, high] = std::minmax(a, b);
    return std::uint64_t{low} << 32U | high;
}

}  // namespace

FloatingLinks::FloatingLinks(RuleContext& context, const LayerGeometry& copper, double reach)
    : m_context(context), m_copper(copper), m_reach(reach) {
    const auto ownerOf = [&](std::uint32_t row) { return context.owners().of(copper.elementOf(row)); };
    const auto isFloating = [&](std::uint32_t row) { return !context.netOf(copper.elementOf(row)).isValid(); };
    PairRequest request;
    request.reach = reach;
    request.isWanted = [&](std::uint32_t a, std::uint32_t b) {
        return ownerOf(a) != ownerOf(b) && (isFloating(a) || isFloating(b));
    };
    request.groupOf = [&](std::uint32_t a, std::uint32_t b) { return keyOf(ownerOf(a), ownerOf(b)); };
    for (const FigurePair& pair : closestPairs(copper, copper, request, context.progress())) {
        add(pair);
    }
}

void FloatingLinks::add(const FigurePair& pair) {
    const Spacing& s = pair.spacing;
    const FigurePair back{pair.b, pair.a, {s.distance, s.to, s.from}};
    for (const FigurePair& nearest : {pair, back}) {
        const ElementId from = m_copper.elementOf(nearest.a);
        const std::uint32_t owner = m_context.owners().of(from);
        m_links[owner].push_back({m_context.owners().of(m_copper.elementOf(nearest.b)), nearest});
        m_isFloating[owner] = !m_context.netOf(from).isValid();
    }
}

std::vector<FloatingLinks::Path> FloatingLinks::paths(const LinkLength& lengthOf) const {
    std::map<std::uint64_t, double> lengths;  // by the owners on either side
    for (const auto& [owner, links] : m_links) {
        for (const Link& link : links) {
            if (!lengths.contains(keyOf(owner, link.to)) && !m_context.progress().isCancelled()) {
                lengths[keyOf(owner, link.to)] = lengthOf(link.nearest);
            }
        }
    }
    std::vector<Path> paths;
    for (const auto& [owner, isFloating] : m_isFloating) {
        if (!isFloating && !m_context.progress().isCancelled()) {
            addPathsFrom(owner, lengths, paths);
        }
    }
    return paths;
}

/// From piece to piece, the nearest one first; a path ends at the first net it comes to.
void FloatingLinks::addPathsFrom(std::uint32_t net, const std::map<std::uint64_t, double>& lengths,
                                 std::vector<Path>& paths) const {
    using Step = std::tuple<double, std::uint32_t>;  // length so far, owner
    std::priority_queue<Step, std::vector<Step>, std::greater<>> open;
    std::map<std::uint32_t, Reached> reached;
    std::map<std::uint32_t, Path> ends;  // by net
    open.emplace(0.0, net);
    reached[net] = {};
    while (!open.empty()) {
        const auto [length, owner] = open.top();
        open.pop();
        if (length > reached[owner].length) {
            continue;
        }
        for (const Link& link : m_links.at(owner)) {
            const double whole = length + lengths.at(keyOf(owner, link.to));
            const Reached path = owner == net ? Reached{whole, link.nearest.a, link.nearest.spacing.from}
                                              : Reached{whole, reached[owner].start, reached[owner].from};
            if (!(whole < m_reach)) {
                continue;
            }
            if (m_isFloating.at(link.to)) {
                const auto found = reached.find(link.to);
                if (found == reached.end() || whole < found->second.length) {
                    reached[link.to] = path;
                    open.emplace(whole, link.to);
                }
            } else if (link.to > net && (!ends.contains(link.to) || whole < ends[link.to].spacing.distance)) {
                ends[link.to] = {path.start, link.nearest.b, {whole, path.from, link.nearest.spacing.to}};
            }
        }
    }
    for (const auto& [end, path] : ends) {
        paths.push_back(path);
    }
}

}  // namespace model
