#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <tuple>
#include <vector>

#include "model/formats/drawing/drawn_job.h"
#include "model/formats/kicad/text/tree.h"

namespace model::kicad {

/// Which rows of the job the layers of a board are. KiCad knows layers by fixed names (F.Cu, In1.Cu, B.Mask); the job's
/// layers have the names that users see. Copper runs F.Cu, In1.Cu …, B.Cu whatever the numbers in the file, which have
/// changed with KiCad 9.
class BoardLayers {
public:
    /// Fills `job.layers`: silkscreen, paste, mask, copper with the dielectrics of the stackup, mask, paste,
    /// silkscreen, then the rest as documents. `layers` is (layers …), `stackup` (stackup …), which need not be there.
    /// Before KiCad 6 copper had only the name that users gave it, so there `isOld` takes what it is from its number.
    void read(const Item& layers, const Item& stackup, bool isOld, formats::DrawnJob& job, std::string_view file);

    /// The row of a layer by either name; kNoRow if the board has none.
    [[nodiscard]] std::int32_t row(std::string_view name) const;
    /// The rows that a list of names stands for, rising: "*.Cu", "F&B.Cu" and "*.Mask" are all that there are of them.
    /// Names that the board lacks give nothing.
    [[nodiscard]] std::vector<std::int32_t> rows(const Item& names) const;
    /// The fixed name of a row; empty for dielectrics and drills.
    [[nodiscard]] const std::string& nameOf(std::int32_t row) const;
    [[nodiscard]] bool isCopper(std::int32_t row) const;
    /// From the top.
    [[nodiscard]] const std::vector<std::int32_t>& copper() const { return m_copper; }
    /// The copper between two layers of copper, both included, in either order. All if one of them is none.
    [[nodiscard]] std::vector<std::int32_t> span(std::int32_t from, std::int32_t to) const;
    /// The row of the holes from copper to copper, plated or not; made when it is first asked for.
    [[nodiscard]] std::int32_t drills(std::int32_t from, std::int32_t to, bool isPlated, formats::DrawnJob& job);
    /// The row of what is drilled from one copper layer down to another after plating.
    [[nodiscard]] std::int32_t backDrills(std::int32_t from, std::int32_t to, formats::DrawnJob& job);
    /// The row of what is drilled wider from an outer copper layer inwards: counterbores and countersinks.
    [[nodiscard]] std::int32_t wideDrills(std::int32_t from, std::int32_t to, formats::DrawnJob& job);
    /// Does the board say how thick its dielectrics are?
    [[nodiscard]] bool hasStackup() const { return m_hasStackup; }

private:
    struct Named {
        std::string name;
        std::string userName;
        std::string type;
    };

    [[nodiscard]] std::vector<Named> named(const Item& layers, bool isOld) const;
    void add(const Named& layer, formats::DrawnJob& job, std::string_view file);
    void addDielectrics(const Item& row, formats::DrawnJob& job, std::string_view file);
    void addPhysical(const std::vector<Named>& layers, const Item& stackup, formats::DrawnJob& job,
                     std::string_view file);

    std::map<std::string, std::int32_t, std::less<>> m_rows;
    enum class DrillKind : std::uint8_t { Plated, NonPlated, BackDrill, Wide };
    [[nodiscard]] std::int32_t drillRow(std::int32_t from, std::int32_t to, DrillKind kind, formats::DrawnJob& job);

    std::map<std::tuple<std::int32_t, std::int32_t, DrillKind>, std::int32_t> m_drills;
    std::vector<std::string> m_names;  ///< by row
    std::vector<std::int32_t> m_copper;
    bool m_hasStackup = false;
};

}  // namespace model::kicad
