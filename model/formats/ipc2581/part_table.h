#pragma once

#include <map>
#include <string_view>
#include <unordered_map>
#include <utility>
#include <vector>

#include "model/formats/drawing/drawn_job.h"
#include "model/formats/ipc2581/layer_list.h"
#include "model/formats/ipc2581/net_table.h"
#include "model/formats/ipc2581/shape_reader.h"

namespace model::ipc2581 {

/// What the bill of materials says of a part.
struct BomPart {
    bool isPopulated = true;
    std::size_t item = 0;  ///< of Bom::items
};

/// All BomItems of the file. A part that none of them names is there all the same: KiCad 9 leaves out the back side.
struct Bom {
    explicit Bom(Reading& reading);
    std::vector<formats::Words> items;
    std::unordered_map<std::string_view, BomPart> parts;  ///< by designator as written
};

/// A pad that says which pin it is of.
struct PadUse {
    std::size_t layer = 0;       ///< row of the LayerList
    std::size_t feature = 0;     ///< of DrawnStep::features
    std::string_view component;  ///< designator and pin as written
    std::string_view pin;
    bool isCopper = false;
};

/// The packages, components and pins of a step.
///
/// Where package coordinates say pins are depends on what a writer means by rotation and mirror, so it is found out:
/// of the ways to place the parts of a side, the one that puts most pins on the pads that name them counts for all of
/// them (decision 162). Pads are where they are; a pin lies where its pad is. Where a package lists pads of one name
/// only once (KiCad), it learns the others from the first part that has them, for bodies follow from all pads.
class PartTable {
public:
    PartTable(Reading& reading, const LayerList& layers, const Bom& bom, ShapeReader& shapes, NetTable& nets,
              formats::DrawnStep& step)
        : m_reading(reading), m_layers(layers), m_bom(bom), m_shapes(shapes), m_nets(nets), m_step(step) {}

    void addPackage(XmlCursor& at);
    void addComponent(XmlCursor& at);
    void addNet(XmlCursor& at);
    void addPad(const PadUse& use) { m_pads.push_back(use); }
    /// Once everything is read: places components and pins, and links pads with them.
    void finish();

private:
    struct Orientation;
    struct PinKey {
        std::int32_t component = 0;
        std::string_view pin;
        bool operator==(const PinKey&) const = default;
    };
    struct PinHash {
        std::size_t operator()(const PinKey& key) const noexcept {
            return std::hash<std::string_view>()(key.pin) * 31 + static_cast<std::size_t>(key.component);
        }
    };
    struct Source {
        double ccwDeg = 0.0;
        bool isMirrored = false;
    };

    [[nodiscard]] LayerSide sideOf(const XmlCursor& at, bool isMirrored) const;
    [[nodiscard]] std::int32_t componentNamed(std::string_view name) const;
    void addPins(std::int32_t component, std::int32_t package);
    void addPin(std::int32_t component, std::string_view name, std::int32_t packagePin);
    void addPackagePin(XmlCursor& at, formats::DrawnPackage& package, std::vector<std::string_view>& names);
    void orient(LayerSide side);
    [[nodiscard]] std::size_t score(LayerSide side, const Orientation& orientation) const;
    [[nodiscard]] Placement placed(std::size_t component, const Orientation& orientation) const;
    [[nodiscard]] bool liesOnItsPin(const PadUse& use) const;
    [[nodiscard]] std::int32_t pinAt(const PadUse& use, std::int32_t component);
    [[nodiscard]] std::int32_t packagePinAt(const PadUse& use, std::int32_t component);
    [[nodiscard]] const formats::DrawnPackagePin* fittingPin(const PadUse& use, std::int32_t component) const;
    void addMissingPins();
    void placePins();
    void linkPads();
    [[nodiscard]] const formats::DrawnFeature& featureOf(const PadUse& use) const {
        return m_step.features[use.layer][use.feature];
    }

    Reading& m_reading;
    const LayerList& m_layers;
    const Bom& m_bom;
    ShapeReader& m_shapes;
    NetTable& m_nets;
    formats::DrawnStep& m_step;
    std::vector<PadUse> m_pads;
    std::vector<Source> m_sources;  ///< by component: as its Xform says
    std::unordered_map<std::string_view, std::int32_t> m_packages;
    std::unordered_map<std::string_view, std::int32_t> m_components;
    std::vector<Nm> m_packageHeights;
    std::vector<std::vector<std::string_view>> m_packagePins;               ///< names as written
    std::unordered_map<std::int32_t, std::int32_t> m_teachers;              ///< components that packages learn from
    std::unordered_map<PinKey, std::vector<std::int32_t>, PinHash> m_pins;  ///< several pins may have one name
    std::unordered_map<PinKey, std::int32_t, PinHash> m_pinNets;            ///< as LogicalNets say
    /// Components and pins that have a pad, and on which layer.
    std::map<std::pair<std::int32_t, std::int32_t>, std::size_t> m_taken;
};

}  // namespace model::ipc2581
