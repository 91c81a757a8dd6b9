#pragma once

#include <string>
#include <unordered_map>
#include <vector>

#include "model/formats/ipc2581/canvas.h"
#include "model/formats/ipc2581/layer_list.h"
#include "model/formats/ipc2581/net_table.h"
#include "model/formats/ipc2581/padstacks.h"
#include "model/formats/ipc2581/part_table.h"
#include "model/formats/ipc2581/shape_reader.h"
#include "model/formats/ipc2581/stack_holes.h"

namespace model::ipc2581 {

/// Reads what is on the layers of a step: the Sets of its LayerFeatures, and the PadStacks of revisions A and B.
class FeatureReader {
public:
    FeatureReader(Reading& reading, const Dictionaries& dictionaries, const Specs& specs, LayerList& layers,
                  Canvas& canvas, NetTable& nets, PartTable& parts, formats::DrawnStep& step)
        : m_reading(reading),
          m_dictionaries(dictionaries),
          m_specs(specs),
          m_layers(layers),
          m_canvas(canvas),
          m_shapes(reading, dictionaries, canvas),
          m_nets(nets),
          m_parts(parts),
          m_step(step),
          m_padstacks(reading) {}

    /// A PadStackDef: the shapes that pads without a shape of their own mean.
    void addPadStackDef(XmlCursor& at) { m_padstacks.add(at); }
    void readLayerFeature(XmlCursor& at);
    /// A PadStack with its net, holes and pads on several layers.
    void readPadStack(XmlCursor& at);
    /// Once all has been read.
    void finish();

private:
    /// Where on a layer the features of a Set begin.
    struct SetStart {
        std::size_t layer = 0;
        std::size_t feature = 0;
    };
    /// What the attributes of a Set say, and what it draws: on its own layer, and holes on a layer of holes.
    struct Set {
        std::int32_t net = formats::kNoRow;
        formats::Words words;
        std::vector<SetStart> starts;
        bool isText = false;
    };
    struct PinRef {
        std::string_view component;
        std::string_view pin;
    };
    /// A Pad, LayerPad, Features or fiducial: where it is and what it draws there.
    struct Placed {
        Turn turn;
        std::vector<PointD> locations;
        std::vector<XmlCursor> shapes;
        std::vector<PinRef> pins;

        [[nodiscard]] Turn at(PointD location) const {
            return {{turn.origin.x + location.x, turn.origin.y + location.y}, turn.ccwDeg, turn.isMirrored, turn.scale};
        }
    };

    void beginLayer(std::size_t layer);
    void readSet(XmlCursor& at);
    void readPart(XmlCursor& at, Set& set);
    void noteStart(Set& set) const;
    void endSet(const Set& set);
    void readCut(XmlCursor& at, Set& set);
    void readPad(XmlCursor& at);
    void readFeatures(XmlCursor& at);
    void readSpec(const XmlCursor& at);
    void readHole(XmlCursor& at);
    [[nodiscard]] Turn readHolePlace(XmlCursor& at);
    void drawHole(const XmlCursor& start, const Turn& turn);
    void readLayerHole(XmlCursor& at, std::int32_t net);
    void readSlot(XmlCursor& at);
    void drillIfStadium(formats::DrawnFeature& feature);
    void readPlaced(XmlCursor& at, Placed& placed);
    void drawPlaced(Placed& placed);
    void usePadstack(std::string_view name, const Placed& placed, std::uint32_t line);
    void drawPadstack(const Padstack* padstack, std::string_view name, const Turn& turn, std::uint32_t line);
    bool drawShapesOf(const Padstack& padstack, const Turn& turn);
    void checkThermals(const Padstack& padstack, const Placed& placed, std::uint32_t line);
    void setKind(SubnetKind kind) { m_canvas.ink().subnet = kind; }
    void setNet(std::int32_t net);
    void setPlating(const XmlCursor& at);
    void addTool(const XmlCursor& at, Nm diameter);
    [[nodiscard]] std::int32_t attributesOf(const formats::Words& words);

    Reading& m_reading;
    const Dictionaries& m_dictionaries;
    const Specs& m_specs;
    LayerList& m_layers;
    Canvas& m_canvas;
    ShapeReader m_shapes;
    NetTable& m_nets;
    PartTable& m_parts;
    formats::DrawnStep& m_step;
    std::size_t m_layer = 0;
    bool m_isVia = false;  ///< what the Set being read says of its pads
    Padstacks m_padstacks;
    std::vector<StackHole> m_stackHoles;  ///< drawn when it is known which of them layers draw
    std::unordered_map<std::string, std::int32_t> m_attributes;
};

}  // namespace model::ipc2581
