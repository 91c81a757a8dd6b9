#pragma once

#include <map>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "model/formats/drawing/drawn_job.h"
#include "model/formats/ipc2581/layer_list.h"
#include "model/formats/ipc2581/reading.h"

namespace model::ipc2581 {

/// A PadstackPadDef: what pads that name only their padstack draw on a layer.
struct PadstackPad {
    std::string_view layer;  ///< as written
    Turn turn;               ///< in the pad
    XmlCursor shape;         ///< at its start tag
};

/// A PadStackDef. Of thermals and antipads only the names of their shapes are kept.
struct Padstack {
    /// A shape of a dictionary on a layer, both as written.
    using NamedShape = std::pair<std::string_view, std::string_view>;

    std::vector<PadstackPad> pads;
    std::vector<PointD> holes;  ///< centres in the pad, in nanometres
    double widestHole = 0.0;    ///< in nanometres
    std::vector<NamedShape> thermals;
    std::vector<NamedShape> antipads;

    /// Is that shape what joins a plane on that layer, and not what keeps clear of it?
    [[nodiscard]] bool isThermal(std::string_view layer, std::string_view shape) const;
};

/// The PadStackDefs of a step. They are a library: pads mostly bring shapes of their own, and holes are drawn by layers
/// of holes. Holes that only a padstack knows are reported.
class Padstacks {
public:
    explicit Padstacks(Reading& reading) : m_reading(reading) {}

    void add(XmlCursor& at);
    /// nullptr: there is none of that name.
    [[nodiscard]] const Padstack* find(std::string_view name) const;
    /// A pad names the padstack and lies there.
    void use(const Padstack& padstack, const Turn& turn, std::uint32_t line);
    /// Reports holes of the padstacks used where no layer of holes draws anything.
    void reportMissingHoles(const formats::DrawnStep& step, const LayerList& layers) const;

private:
    /// A hole of a padstack that a pad uses.
    struct HoleUse {
        Point turned;    ///< where it lies if its place is one in the pad
        Point opposite;  ///< where KiCad 9 means it: it writes where the pad lies as seen from the hole, not turned
        std::uint32_t line = 0;
    };

    void addPad(XmlCursor& at, Padstack& padstack);

    Reading& m_reading;
    std::unordered_map<std::string_view, Padstack> m_padstacks;
    std::map<std::pair<Nm, Nm>, HoleUse> m_holes;  ///< by place, with the line of the first pad
};

}  // namespace model::ipc2581
