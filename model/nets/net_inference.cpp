#include "model/nets/net_inference.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <string>
#include <unordered_map>
#include <utility>

#include "model/board/document_builder.h"
#include "model/nets/connectivity.h"

namespace model {

namespace {

constexpr std::string_view kNoNetName = "$NONE$";

class NetFinder {
public:
    NetFinder(Document& document, const Connectivity& connectivity)
        : m_document(document), m_connectivity(connectivity), m_names(connectivity.pieceCount()) {
        for (std::size_t row = 0; row < document.layers.size(); ++row) {
            if (document.layers[row].isCopper()) {
                m_top = m_top.isValid() ? m_top : LayerId{row};
                m_bottom = LayerId{row};
            }
        }
    }

    void run() {
        namePieces();
        spreadNames();
        m_document.nets = {};
        m_document.subnets = {};
        m_document.elements.subnet.edit().assign(m_document.elements.size(), SubnetId{});
        makeNets();
        assignElements();
        for (Pin& pin : m_document.pins.edit()) {
            pin.net = netAt(pin.position, m_document.components[pin.component.row()].side);
        }
        indexNets(m_document);
    }

private:
    void report(Severity severity, const std::string& text, ElementId element) {
        const Layer& layer = m_document.layer(m_document.elements.layer[element.row()]);
        m_document.diagnostics.report(severity, layer.file, m_document.elements.line[element.row()], text, element);
    }

    /// Pieces a side's outer copper has at a location.
    [[nodiscard]] std::vector<std::uint32_t> piecesAt(Point p, LayerSide side) const {
        if (!m_top.isValid()) {
            return {};
        }
        return m_connectivity.piecesAt(side == LayerSide::Bottom ? m_bottom : m_top, p, 0);
    }

    /// Of the pieces at a location the one that was most likely made for it, a pad: its middle is nearest.
    [[nodiscard]] std::vector<std::uint32_t> nearestAt(Point p, LayerSide side) const {
        std::vector<std::uint32_t> pieces = piecesAt(p, side);
        const auto distance = [&](std::uint32_t piece) {
            const Point middle = m_document.boxOf(m_connectivity.element(piece)).middle();
            return std::hypot(double(middle.x) - double(p.x), double(middle.y) - double(p.y));
        };
        std::ranges::stable_sort(pieces, {}, distance);
        return pieces;
    }

    [[nodiscard]] NetId netAt(Point p, LayerSide side) const {
        const std::vector<std::uint32_t> pieces = nearestAt(p, side);
        return pieces.empty() ? NetId{} : m_nets[pieces.front()];
    }

    /// Points name the nearest piece that no point of another net has named.
    void namePieces() {
        for (const NetPoint& point : m_document.netPoints) {
            const std::string& name = m_document.text(point.name);
            if (name.empty() || name == kNoNetName) {
                continue;
            }
            const std::vector<std::uint32_t> pieces = nearestAt(point.position, point.side);
            const auto free = std::ranges::find_if(
                pieces, [&](std::uint32_t piece) { return !m_names[piece].isValid() || m_names[piece] == point.name; });
            if (free != pieces.end()) {
                m_names[*free] = point.name;
            }
            if (!pieces.empty()) {
                noteName(point, pieces.front());
            }
        }
    }

    /// Reports an island that points of several nets name.
    void noteName(const NetPoint& point, std::uint32_t piece) {
        const auto [known, isNew] = m_nameOfIsland.try_emplace(m_connectivity.island(piece), point.name);
        if (!isNew && known->second != point.name && m_reported.emplace(known->first, point.name).second) {
            report(Severity::Warning,
                   "netlist points of " + m_document.text(known->second) + " and " + m_document.text(point.name) +
                       " lie on one island of copper, which is divided among these nets; where they join is not known",
                   m_connectivity.element(piece));
        }
    }

    /// What no point lies on has the name of what it touches; of several the one that is fewer pieces away.
    void spreadNames() {
        std::vector<std::vector<std::uint32_t>> touching(m_connectivity.pieceCount());
        for (const Contact& contact : m_connectivity.contacts()) {
            touching[contact.a].push_back(contact.b);
            touching[contact.b].push_back(contact.a);
        }
        std::vector<std::uint32_t> reached;
        for (std::uint32_t piece = 0; piece < m_names.size(); ++piece) {
            if (m_names[piece].isValid()) {
                reached.push_back(piece);
            }
        }
        for (std::size_t i = 0; i < reached.size(); ++i) {
            for (const std::uint32_t other : touching[reached[i]]) {
                if (!m_names[other].isValid()) {
                    m_names[other] = m_names[reached[i]];
                    reached.push_back(other);
                }
            }
        }
    }

    /// One per name, and one per island without any.
    void makeNets() {
        std::map<StringId, NetId> named;
        std::map<std::uint32_t, NetId> unnamed;
        for (std::uint32_t piece = 0; piece < m_names.size(); ++piece) {
            const StringId name = m_names[piece];
            const NetId next{m_document.nets.size()};
            const NetId net = name.isValid() ? named.try_emplace(name, next).first->second
                                             : unnamed.try_emplace(m_connectivity.island(piece), next).first->second;
            if (net == next) {
                m_document.nets.push_back(
                    {name.isValid() ? m_document.text(name) : "$" + std::to_string(unnamed.size()), {}});
            }
            m_nets.push_back(net);
        }
        addNetsWithoutCopper(named);
        for (NetPoint& point : m_document.netPoints.edit()) {
            const auto found = named.find(point.name);
            point.net = found == named.end() ? NetId{} : found->second;
        }
    }

    /// Nets whose points all lie on copper that has the name of another one.
    void addNetsWithoutCopper(std::map<StringId, NetId>& named) {
        for (const auto& [island, name] : m_reported) {
            if (named.try_emplace(name, NetId{m_document.nets.size()}).second) {
                m_document.nets.push_back({m_document.text(name), {}});
            }
        }
    }

    void assignElements() {
        std::vector<NetId>& nets = m_document.elements.net.edit();
        nets.assign(nets.size(), NetId{});
        for (std::uint32_t piece = 0; piece < m_connectivity.pieceCount(); ++piece) {
            const ElementId element = m_connectivity.element(piece);
            const NetId net = m_nets[piece];
            NetId& known = nets[element.row()];
            if (known.isValid() && known != net) {
                report(Severity::Info, "its pieces are in several nets; it is listed in that of the first", element);
                continue;
            }
            known = net;
        }
    }

    Document& m_document;
    const Connectivity& m_connectivity;
    std::vector<StringId> m_names;                            ///< by piece; none where no point lies on its island
    std::vector<NetId> m_nets;                                ///< by piece
    std::map<std::uint32_t, StringId> m_nameOfIsland;         ///< the first one
    std::set<std::pair<std::uint32_t, StringId>> m_reported;  ///< islands, and further names of them
    LayerId m_top;
    LayerId m_bottom;
};

using Done = std::unordered_map<const Document*, std::shared_ptr<const Document>>;

base::Result<std::shared_ptr<const Document>> inferred(const Document& document, base::Progress& progress, Done& done) {
    auto copy = std::make_shared<Document>(document);
    for (std::shared_ptr<const Document>& step : copy->steps) {
        std::shared_ptr<const Document>& location = done[step.get()];
        if (location == nullptr) {
            ASSIGN_OR_RETURN(auto result, inferred(*step, progress, done));
            done[step.get()] = result;
        }
        step = done[step.get()];
    }
    ASSIGN_OR_RETURN(const Connectivity connectivity, Connectivity::of(*copy, progress));
    NetFinder(*copy, connectivity).run();
    return std::shared_ptr<const Document>(std::move(copy));
}

}  // namespace

base::Result<std::shared_ptr<const Document>> withInferredNets(const Document& document, base::Progress& progress) {
    Done done;
    return inferred(document, progress, done);
}

bool isNumberedNet(std::string_view name) {
    return name.size() > 1 && name.front() == '$' && name.find_first_not_of("0123456789", 1) == std::string_view::npos;
}

bool areNetsOfCopper(const Document& document) {
    return !document.nets.empty() &&
           std::ranges::all_of(document.nets, [](const Net& net) { return isNumberedNet(net.name); });
}

}  // namespace model
