#include "model/formats/common/net_points.h"

#include <algorithm>
#include <map>
#include <unordered_map>

#include "model/figures/distance.h"
#include "model/formats/common/shift.h"
#include "model/geometry/box_index.h"

namespace model::formats {

namespace {

/// Points and pads are rounded differently by up to a few µm; other pads are farther away.
constexpr Nm kReach = 20'000;
/// A shift is looked for with at most this many points, which is plenty.
constexpr std::size_t kVoters = 500;
/// Fewer points agree on a shift by chance.
constexpr std::size_t kLeastPoints = 2;
/// Names listed in a message.
constexpr std::size_t kListed = 5;

/// Middles of pads and holes by net, and of the pins.
class Landings {
public:
    explicit Landings(const Document& document) : m_locations(document.nets.size()) {
        for (std::size_t row = 0; row < document.elements.size(); ++row) {
            const NetId net = document.elements.net[row];
            if (net.isValid() && (document.elements.flags[row] & (kPad | kHole)) != 0) {
                m_locations[net.row()].push_back(middleOf(document, row));
            }
        }
        for (const Pin& pin : document.pins) {
            if (pin.net.isValid()) {
                m_locations[pin.net.row()].push_back(pin.position);
            }
        }
        for (std::vector<Point>& locations : m_locations) {
            std::ranges::sort(locations);
            locations.erase(std::unique(locations.begin(), locations.end()), locations.end());
            m_all.insert(m_all.end(), locations.begin(), locations.end());
        }
        std::ranges::sort(m_all);
    }

    [[nodiscard]] const std::vector<Point>& of(NetId net) const { return m_locations[net.row()]; }

    [[nodiscard]] bool has(NetId net, Point p) const { return holds(of(net), p); }
    [[nodiscard]] bool hasAny(Point p) const { return holds(m_all, p); }

private:
    static bool holds(const std::vector<Point>& locations, Point p) {
        for (auto at = std::ranges::lower_bound(locations, Point{p.x - kReach, p.y - kReach});
             at != locations.end() && at->x <= p.x + kReach; ++at) {
            if (std::abs(at->y - p.y) <= kReach) {
                return true;
            }
        }
        return false;
    }

    static Point middleOf(const Document& document, std::size_t row) {
        const std::uint32_t geometry = document.elements.geometry[row];
        switch (document.elements.kind[row]) {
            case ElementKind::Circle: return document.circles[geometry].centre;
            case ElementKind::Area: return document.areas[geometry].placement.origin;
            default: return document.boxOf(ElementId{row}).middle();
        }
    }

    std::vector<std::vector<Point>> m_locations;
    std::vector<Point> m_all;  ///< of all nets, rising
};

/// Some jobs have several nets of one name; the netlist then lists it as often, in another order.
using NetsByName = std::unordered_map<std::string_view, std::vector<NetId>>;

/// What lies under a point, off the middles of all pads of its net.
enum class Ground { Nothing, NoNet, OwnNet };

/// Looks for what covers points: exact, by a pass over all elements.
std::vector<Ground> groundsOf(const Document& document, const std::vector<NetPoint>& points) {
    if (points.empty()) {
        return {};
    }
    FigureTable discs;
    std::vector<Box> places;
    for (const NetPoint& point : points) {
        discs.addDisc(point.position, 0.0);
        places.push_back({point.position, point.position});
    }
    const BoxIndex index(places);
    std::vector<Ground> grounds(points.size(), Ground::Nothing);
    // A plane may have hundreds of thousands of edges and as many points over it: its figures are made once.
    const auto check = [&](ElementId element) {
        const NetId net = document.elements.net[element.row()];
        FigureTable figures;
        index.visit(document.boxOf(element), [&](std::uint32_t i) {
            const bool isOfOther = net.isValid() && net != points[i].net;
            if (grounds[i] == Ground::OwnNet || isOfOther) {
                return;
            }
            if (figures.size() == 0) {
                figures.add(document, element);
            }
            for (std::size_t row = 0; row < figures.size(); ++row) {
                if (spacingBetween(figures, row, discs, i, kTouchNm)) {
                    grounds[i] = net.isValid() ? Ground::OwnNet : Ground::NoNet;
                }
            }
        });
    };
    for (std::size_t row = 0; row < document.elements.size(); ++row) {
        if (document.layer(document.elements.layer[row]).isCopper()) {
            check(ElementId{row});
        }
    }
    return grounds;
}

class NetPointMaker {
public:
    NetPointMaker(DocumentBuilder& builder, const NetlistFile& file, const Landings& landings, const NetsByName& nets)
        : m_builder(builder), m_file(file), m_netlist(*file.netlist), m_landings(landings) {
        for (const std::string& name : m_netlist.names) {
            const auto found = nets.find(name);
            m_nets.push_back(found == nets.end() ? std::span<const NetId>{} : found->second);
        }
    }

    void run() {
        reportUnknownNames();
        const Point shift = findShift();
        std::vector<NetPoint> beside;
        std::vector<std::uint32_t> lines;
        for (const NetlistPoint& from : m_netlist.points) {
            const NetPoint point = pointFrom(from, shift);
            if (point.net.isValid() && !m_landings.has(point.net, point.position)) {
                beside.push_back(point);
                lines.push_back(from.line);
            }
            m_builder.addNetPoint(point);
        }
        if (m_hasOrigin && beside.size() <= std::max(kVoters, m_netlist.points.size() / 2)) {
            const std::vector<Ground> grounds = groundsOf(m_builder.soFar(), beside);
            reportGround(grounds, Ground::NoNet, lines, "lie on copper without a net");
            reportGround(grounds, Ground::Nothing, lines, "lie on no copper of their net");
        } else if (m_hasOrigin) {
            report(Severity::Warning, lines.front(), countText(beside.size()) + "lie on no pad of their net");
        }
    }

private:
    void report(Severity severity, std::uint32_t line, const std::string& text) {
        m_builder.diagnostics().report(severity, m_file.path, line, text);
    }

    void reportGround(const std::vector<Ground>& grounds, Ground ground, const std::vector<std::uint32_t>& lines,
                      const char* what) {
        const auto count = std::ranges::count(grounds, ground);
        if (count > 0) {
            const auto first = std::ranges::find(grounds, ground) - grounds.begin();
            report(Severity::Warning, lines[static_cast<std::size_t>(first)],
                   countText(static_cast<std::size_t>(count)) + what);
        }
    }

    /// "2 of 4 netlist points "
    [[nodiscard]] std::string countText(std::size_t count) const {
        return std::to_string(count) + " of " + std::to_string(m_netlist.points.size()) + " netlist points ";
    }

    [[nodiscard]] std::span<const NetId> netsOf(const NetlistPoint& point) const {
        return point.number >= 0 && static_cast<std::size_t>(point.number) < m_nets.size()
                   ? m_nets[static_cast<std::size_t>(point.number)]
                   : std::span<const NetId>{};
    }

    [[nodiscard]] NetId netOf(const NetlistPoint& point) const {
        const std::span<const NetId> nets = netsOf(point);
        return nets.empty() ? NetId{} : nets.front();
    }

    /// Of several nets of its name the one that has a pad or hole there.
    [[nodiscard]] NetId netAt(const NetlistPoint& point, Point location) const {
        const std::span<const NetId> nets = netsOf(point);
        const auto there = std::ranges::find_if(nets, [&](NetId net) { return m_landings.has(net, location); });
        return there == nets.end() ? netOf(point) : *there;
    }

    void reportUnknownNames() {
        std::string list;
        std::size_t unknown = 0;
        std::size_t known = 0;
        for (std::size_t i = 0; i < m_nets.size(); ++i) {
            const std::string& name = m_netlist.names[i];
            if (name.empty() || name == m_netlist.noNet) {
                continue;
            }
            if (!m_nets[i].empty()) {
                ++known;
            } else if (unknown++ < kListed) {
                list += (list.empty() ? "" : ", ") + name;
            }
        }
        if (unknown > 0 && known == 0 && m_file.kind == NetlistKind::Current) {
            report(Severity::Info, 0,
                   "the netlist was made from the copper and numbers its nets (" + list + ", …); it names none");
        } else if (unknown > 0) {
            report(Severity::Warning, 0,
                   std::to_string(unknown) + (unknown == 1 ? " net of the netlist is" : " nets of the netlist are") +
                       " not on the board: " + list + (unknown > kListed ? ", …" : ""));
        }
    }

    [[nodiscard]] std::size_t landed(Point shift) const {
        return static_cast<std::size_t>(std::ranges::count_if(m_netlist.points, [&](const NetlistPoint& point) {
            const NetId net = netOf(point);
            return net.isValid() && m_landings.has(net, moved(point.position, shift));
        }));
    }

    static Point between(Point from, Point to) { return moved(to, {-from.x, -from.y}); }

    [[nodiscard]] Point findShift() {
        const auto named = static_cast<std::size_t>(
            std::ranges::count_if(m_netlist.points, [&](const NetlistPoint& p) { return netOf(p).isValid(); }));
        if (2 * landed({}) >= named || liesOnPads()) {
            return {};
        }
        // Every point votes for the shifts that put it on a landing of its net, on a grid coarser than the rounding.
        std::map<Point, std::pair<std::size_t, Point>> votes;
        std::size_t voters = 0;
        for (const NetlistPoint& point : m_netlist.points) {
            const NetId net = netOf(point);
            if (!net.isValid() || m_landings.of(net).size() > kVoters || voters++ >= kVoters) {
                continue;
            }
            for (const Point location : m_landings.of(net)) {
                const Point shift = between(point.position, location);
                auto& [count, first] = votes[{shift.x / kReach, shift.y / kReach}];
                first = count++ == 0 ? shift : first;
            }
        }
        const auto best = std::ranges::max_element(votes, {}, [](const auto& vote) { return vote.second.first; });
        const std::size_t there = best == votes.end() ? 0 : landed(best->second.second);
        if (there < kLeastPoints || 2 * there < named || there < 2 * landed({})) {
            m_hasOrigin = false;
            report(Severity::Warning, 0, "most netlist points lie on no pad of their net, with any origin");
            return {};
        }
        report(Severity::Info, 0, "the netlist counts from another origin than the layers; its points were moved");
        return best->second.second;
    }

    /// Do most points lie on pads or pins as they are, of whatever net? Then they count from the same origin, and the
    /// nets are wrong.
    [[nodiscard]] bool liesOnPads() const {
        const auto lying = std::ranges::count_if(
            m_netlist.points, [&](const NetlistPoint& point) { return m_landings.hasAny(point.position); });
        return 2 * static_cast<std::size_t>(lying) > m_netlist.points.size();
    }

    NetPoint pointFrom(const NetlistPoint& from, Point shift) {
        NetPoint point = from;
        const bool isNamed = from.number >= 0 && static_cast<std::size_t>(from.number) < m_netlist.names.size();
        point.name = m_builder.string(isNamed ? m_netlist.names[static_cast<std::size_t>(from.number)] : "");
        point.position = moved(from.position, shift);
        point.net = netAt(from, point.position);
        point.netlist = m_file.kind;
        return point;
    }

    DocumentBuilder& m_builder;
    const NetlistFile& m_file;
    const Netlist& m_netlist;
    const Landings& m_landings;
    bool m_hasOrigin = true;                     ///< is it known where the netlist counts from?
    std::vector<std::span<const NetId>> m_nets;  ///< by number of the name
};

}  // namespace

void addNetPoints(DocumentBuilder& builder, std::span<const NetlistFile> files) {
    if (std::ranges::all_of(files, [](const NetlistFile& file) { return file.netlist->points.empty(); })) {
        return;
    }
    const Landings landings(builder.soFar());
    NetsByName nets;
    for (std::size_t row = 0; row < builder.soFar().nets.size(); ++row) {
        nets[builder.soFar().nets[row].name].push_back(NetId{row});
    }
    for (const NetlistFile& file : files) {
        NetPointMaker(builder, file, landings, nets).run();
    }
}

}  // namespace model::formats
