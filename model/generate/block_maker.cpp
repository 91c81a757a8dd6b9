#include "model/generate/block_maker.h"

#include <algorithm>
#include <bitset>

namespace model::generate {

namespace {

constexpr int kMaxVias = 8;
constexpr int kCirclesPerVia = 3;
constexpr int kSitesPerRow = 16;
// Heights and pitches in a block, µm.
constexpr std::int32_t kUpperRow = 3400;
constexpr std::int32_t kLowerRow = 600;
constexpr std::int32_t kViaRow = 2700;
constexpr std::int32_t kTestRow = 1300;
constexpr std::int32_t kPitch = 400;
constexpr std::int32_t kFirstTrack = 700;
constexpr std::int32_t kTrackPitch = 500;

/// Every other site of a row of pads is above a via.
constexpr std::int32_t siteX(int site) {
    return kPitch + kPitch * site + (site >= kSitesPerRow / 2 ? 800 : 0);
}

/// Goes from a to b along the axis that `along` and `aside` span, stepping aside and back `bumps` times.
struct Meander {
    PointUm along;
    PointUm aside;
    int bumps;
};

PointUm moved(PointUm p, PointUm step, std::int32_t by) {
    return {p.x + step.x * by, p.y + step.y * by};
}

/// Corners between `from` and the point `length` along, both left out; four tracks are added per bump.
void meander(PointUm from, const Meander& how, std::int32_t length, std::int32_t depth, std::vector<PointUm>& path) {
    for (int i = 0; i < how.bumps; ++i) {
        const std::int32_t out = length * (2 * i + 1) / (2 * how.bumps + 1);
        const std::int32_t back = length * (2 * i + 2) / (2 * how.bumps + 1);
        path.push_back(moved(from, how.along, out));
        path.push_back(moved(moved(from, how.along, out), how.aside, depth));
        path.push_back(moved(moved(from, how.along, back), how.aside, depth));
        path.push_back(moved(from, how.along, back));
    }
}

}  // namespace

BlockMaker::BlockMaker(PointUm corner, const BlockShare& share) : m_corner(corner), m_share(share) {
    m_vias = std::min(kMaxVias, share.circles / kCirclesPerVia);
    m_bottomTrails = std::min(share.trails, m_vias / 2);
    m_topTrails = share.trails - m_bottomTrails;
    m_fanOuts = std::min({share.lines * 2 / 3, m_vias, std::max(0, share.pads - 2 * m_topTrails)});
    m_block.netCount = share.trails;
}

Block BlockMaker::make() {
    addVias();
    addTestPads();
    addBottomTrails();
    addTopTrails();
    addPads();
    addPrint();
    return std::move(m_block);
}

/// Vias 2p and 2p + 1 are a pair: number p from the left end and number p from the right end, so that their traces
/// nest.
PointUm BlockMaker::viaSite(int via) const {
    const int fromEnd = via / 2;
    const int site = 2 * (via % 2 == 0 ? fromEnd : kMaxVias - 1 - fromEnd);
    return {m_corner.x + siteX(site), m_corner.y + kViaRow};
}

BlockNet BlockMaker::netOfVia(int via) const {
    if (via / 2 < m_bottomTrails) {
        return via / 2;
    }
    return via % 2 == 0 ? kGroundNet : kPowerNet;
}

int BlockMaker::random(int choices) {
    const auto choice = static_cast<int>(m_share.random % static_cast<std::uint64_t>(choices));
    m_share.random = m_share.random * 6364136223846793005U + 1442695040888963407U;
    m_share.random ^= m_share.random >> 29U;
    return choice;
}

void BlockMaker::addPad(BoardLayer plane, PointUm at, Pen pen, BlockNet net) {
    m_block.features[static_cast<std::size_t>(plane)].push_back({Feature::Kind::Pad, pen, net, at, {}, {}});
}

void BlockMaker::addTrack(BoardLayer plane, PointUm a, PointUm b, Pen pen, BlockNet net) {
    m_block.features[static_cast<std::size_t>(plane)].push_back({Feature::Kind::Track, pen, net, a, b, {}});
}

void BlockMaker::addTrail(BoardLayer plane, const std::vector<PointUm>& path, BlockNet net) {
    for (std::size_t i = 0; i + 1 < path.size(); ++i) {
        addTrack(plane, path[i], path[i + 1], Pen::Trace, net);
    }
}

void BlockMaker::addVias() {
    for (int via = 0; via < m_vias; ++via) {
        const PointUm at = viaSite(via);
        const BlockNet net = netOfVia(via);
        addPad(BoardLayer::Top, at, Pen::ViaPad, net);
        addPad(BoardLayer::Bottom, at, Pen::ViaPad, net);
        addPad(BoardLayer::Drill, at, Pen::Drill, net);
        if (net != kGroundNet) {
            m_block.viasNotOnGround.push_back(at);
        }
        if (net != kPowerNet) {
            m_block.viasNotOnPower.push_back(at);
        }
    }
}

void BlockMaker::addTestPads() {
    for (int i = 0; i < m_share.circles - kCirclesPerVia * m_vias; ++i) {
        addPad(BoardLayer::Top, {m_corner.x + siteX(2 * (i % kMaxVias)), m_corner.y + kTestRow}, Pen::TestPad, kNoNet);
    }
}

void BlockMaker::addBottomTrails() {
    const auto spanOf = [&](int trail) { return viaSite(2 * trail + 1).x - viaSite(2 * trail).x; };
    std::int64_t spans = 0;
    for (int trail = 0; trail < m_bottomTrails; ++trail) {
        spans += spanOf(trail);
    }
    for (int trail = 0; trail < m_bottomTrails; ++trail) {
        const PointUm from = viaSite(2 * trail);
        const PointUm to = viaSite(2 * trail + 1);
        const std::int32_t y = m_corner.y + kFirstTrack + kTrackPitch * trail;
        const std::int32_t depth = 120 + 20 * random(6);
        // Long traces take more of the tracks; three are the way down, along and up.
        const std::int64_t tracks = std::int64_t{m_share.tracksPerTrail} * m_bottomTrails * spanOf(trail) / spans;
        const int bumps = static_cast<int>(std::max<std::int64_t>(0, (tracks - 3 + 2) / 4));
        std::vector<PointUm> path{from, {from.x, y}};
        meander(path.back(), {{1, 0}, {0, 1}, bumps}, to.x - from.x, depth, path);
        path.insert(path.end(), {{to.x, y}, to});
        addTrail(BoardLayer::Bottom, path, trail);
    }
}

void BlockMaker::addTopTrails() {
    for (int trail = 0; trail < m_topTrails; ++trail) {
        // Sites between the vias, the two cells in turn.
        const std::int32_t x = m_corner.x + siteX(1 + 2 * (trail / 2) + (trail % 2) * kSitesPerRow / 2);
        const std::int32_t depth = 60 + 10 * random(5);
        const PointUm from{x, m_corner.y + kUpperRow};
        const PointUm start{x, m_corner.y + kUpperRow - 600};
        std::vector<PointUm> path{from};
        const int bumps = (m_share.tracksPerTrail - 1) / 4;
        if (bumps > 0) {
            meander(start, {{0, -1}, {1, 0}, bumps}, kUpperRow - kLowerRow - 1200, depth, path);
        } else {
            path.insert(path.end(), {start, {x + depth, start.y - depth}});
            path.push_back({x, start.y - 2 * depth});
        }
        path.push_back({x, m_corner.y + kLowerRow});
        addTrail(BoardLayer::Top, path, m_bottomTrails + trail);
    }
}

void BlockMaker::addPads() {
    constexpr Pen kPens[] = {Pen::PadSmall, Pen::PadMiddle, Pen::PadLarge};
    std::bitset<2 * kSitesPerRow> isTaken;  // the upper row, then the lower one
    const Pen pen = kPens[random(3)];       // one part, one kind of pad
    int left = m_share.pads;
    const auto add = [&](int site, BlockNet net) {
        if (left > 0 && !isTaken[static_cast<std::size_t>(site)]) {
            isTaken.set(static_cast<std::size_t>(site));
            --left;
            const std::int32_t y = site < kSitesPerRow ? kUpperRow : kLowerRow;
            addPad(BoardLayer::Top, {m_corner.x + siteX(site % kSitesPerRow), m_corner.y + y}, pen, net);
        }
    };
    for (int trail = 0; trail < m_topTrails; ++trail) {
        const int site = 1 + 2 * (trail / 2) + (trail % 2) * kSitesPerRow / 2;
        add(site, m_bottomTrails + trail);
        add(site + kSitesPerRow, m_bottomTrails + trail);
    }
    for (int via = 0; via < m_fanOuts; ++via) {
        const PointUm at = viaSite(via);
        const PointUm pad{at.x, m_corner.y + kUpperRow};
        const int fromEnd = via / 2;
        add(2 * (via % 2 == 0 ? fromEnd : kMaxVias - 1 - fromEnd), netOfVia(via));
        addTrack(BoardLayer::Top, pad, at, Pen::Trace, netOfVia(via));
    }
    for (int site = 0; site < 2 * kSitesPerRow; ++site) {
        add(site, kNoNet);
    }
}

void BlockMaker::addPrint() {
    for (int i = 0; i < m_share.lines - m_fanOuts; ++i) {
        const std::int32_t x = m_corner.x + 200 + kPitch * i;
        addTrack(BoardLayer::Silk, {x, m_corner.y + 3760}, {x, m_corner.y + 3920}, Pen::Mark, kNoNet);
    }
    for (int i = 0; i < m_share.arcs; ++i) {
        const PointUm centre{m_corner.x + kWidthUm / 4 + i * kWidthUm / 2, m_corner.y + 2000};
        m_block.features[static_cast<std::size_t>(BoardLayer::Silk)].push_back(
            {Feature::Kind::Arc, Pen::Mark, kNoNet, {centre.x - 300, centre.y}, {centre.x + 300, centre.y}, centre});
    }
}

}  // namespace model::generate
