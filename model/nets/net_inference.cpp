#include "model/nets/net_inference.h"

#include <map>
#include <unordered_map>

#include "model/board/document_builder.h"
#include "model/nets/connectivity.h"

namespace model {

namespace {

constexpr std::string_view kNoNetName = "$NONE$";

class NetFinder {
public:
    NetFinder(Document& document, const Connectivity& connectivity)
        : m_document(document), m_connectivity(connectivity), m_names(connectivity.islandCount()) {
        for (std::size_t row = 0; row < document.layers.size(); ++row) {
            if (document.layers[row].isCopper()) {
                m_top = m_top.isValid() ? m_top : LayerId{row};
                m_bottom = LayerId{row};
            }
        }
    }

    void run() {
        nameIslands();
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
    void report(Severity severity, const char* text, ElementId element) {
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

    [[nodiscard]] NetId netAt(Point p, LayerSide side) const {
        const std::vector<std::uint32_t> pieces = piecesAt(p, side);
        return pieces.empty() ? NetId{} : m_nets[m_connectivity.island(pieces.front())];
    }

    void nameIslands() {
        for (const NetPoint& point : m_document.netPoints) {
            const std::string& name = m_document.text(point.name);
            if (name.empty() || name == kNoNetName) {
                continue;
            }
            for (const std::uint32_t piece : piecesAt(point.position, point.side)) {
                StringId& known = m_names[m_connectivity.island(piece)];
                if (known.isValid() && known != point.name) {
                    report(Severity::Warning,
                           "copper that carries netlist points of several nets; the first one names it",
                           m_connectivity.element(piece));
                    continue;
                }
                known = point.name;
            }
        }
    }

    void makeNets() {
        std::map<StringId, NetId> named;
        std::size_t number = 0;
        for (const StringId name : m_names) {
            NetId net{m_document.nets.size()};
            if (name.isValid()) {
                net = named.try_emplace(name, net).first->second;
            }
            if (net.row() == m_document.nets.size()) {
                m_document.nets.push_back(
                    {name.isValid() ? m_document.text(name) : "$" + std::to_string(++number), {}});
            }
            m_nets.push_back(net);
        }
        for (NetPoint& point : m_document.netPoints.edit()) {
            const auto found = named.find(point.name);
            point.net = found == named.end() ? NetId{} : found->second;
        }
    }

    void assignElements() {
        std::vector<NetId>& nets = m_document.elements.net.edit();
        nets.assign(nets.size(), NetId{});
        for (std::uint32_t piece = 0; piece < m_connectivity.pieceCount(); ++piece) {
            const ElementId element = m_connectivity.element(piece);
            const NetId net = m_nets[m_connectivity.island(piece)];
            NetId& known = nets[element.row()];
            if (known.isValid() && known != net) {
                report(Severity::Info, "the islands of an area are in several nets; it is listed in that of the first",
                       element);
                continue;
            }
            known = net;
        }
    }

    Document& m_document;
    const Connectivity& m_connectivity;
    std::vector<StringId> m_names;  ///< by island; none where no point lies
    std::vector<NetId> m_nets;      ///< by island
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

}  // namespace model
