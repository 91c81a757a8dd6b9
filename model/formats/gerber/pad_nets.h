#pragma once

#include <set>
#include <string>
#include <unordered_map>
#include <vector>

#include "model/formats/gerber/board_groups.h"
#include "model/formats/gerber/layer_order.h"
#include "model/formats/gerber/pad_index.h"
#include "model/formats/gerber/parts.h"

namespace model::gerber {

/// The nets of a step by their names.
class NetNames {
public:
    explicit NetNames(formats::DrawnStep& step) : m_step(step) {}

    /// The row of the net of this name, which is made if it is not there.
    [[nodiscard]] std::int32_t row(const std::string& name);

private:
    formats::DrawnStep& m_step;
    std::unordered_map<std::string, std::int32_t> m_rows;
};

/// Brings netlists, pads and holes of a step together, whose layers are in place: nets and pins for the pads at the
/// points of a netlist where images name none, nets for the holes in pads, sizes for tools whose file has none
/// (Allegro's routed slots), and vias where nothing tells what holes are for.
class PadNets {
public:
    PadNets(formats::DrawnStep& step, OrderedLayers& layers, PartList& parts, NetNames& nets, Diagnostics& diagnostics);

    /// `hasNets`: the images name nets, so that netlists are only kept for comparison.
    void run(const std::vector<ReadFile>& files, const BoardFiles& board, bool hasNets);

private:
    void indexPads();
    void add(const ReadFile& file, bool hasNets);
    void giveNet(const D356Point& point, const std::vector<std::string>& names, Point shift);
    [[nodiscard]] std::vector<IndexedPad> padsAt(Point at, LayerSide side);
    [[nodiscard]] bool isWithin(Point at, const formats::DrawnFeature& pad);
    [[nodiscard]] formats::DrawnFeature& featureOf(const IndexedPad& pad);
    [[nodiscard]] LayerSide sideOf(const IndexedPad& pad) const;
    void giveSizes(const ReadFile& file, Point shift);
    [[nodiscard]] bool giveSize(std::size_t layer, std::int32_t symbol, const std::vector<const D356Point*>& holes,
                                Point shift);
    void nameHoles();
    [[nodiscard]] bool isUseOfHolesTold() const;
    void assumeVias();
    [[nodiscard]] std::set<std::int32_t> viaTools(std::size_t layer) const;
    [[nodiscard]] bool mayBeVia(const formats::DrawnFeature& hole) const;
    [[nodiscard]] bool joinsPads(const formats::DrawnFeature& hole) const;
    void reportSizeless();
    [[nodiscard]] std::set<std::int32_t> sizelessTools(std::size_t layer) const;
    [[nodiscard]] bool holdsHoles(std::size_t layer) const;

    formats::DrawnStep& m_step;
    OrderedLayers& m_layers;
    PartList& m_parts;
    NetNames& m_nets;
    Diagnostics& m_diagnostics;
    PadIndex m_pads;  ///< by layer and feature of the step
    std::unordered_map<std::int32_t, Box> m_symbolBoxes;
};

}  // namespace model::gerber
