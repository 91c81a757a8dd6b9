#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "model/board/document.h"

namespace model::odb {

/// A layer of `matrix/stackup.xml` with the material it refers to.
struct XmlLayer {
    std::string name;
    bool isDielectric = false;
    std::optional<double> thicknessNm;
    Material material;
    std::uint32_t line = 0;
};

/// What `matrix/stackup.xml` (ODB++ 8.1) says about the build, as the design source states it (EdaData, else the first
/// SupplierData).
struct StackupXml {
    std::vector<XmlLayer> layers;   ///< from the top
    std::optional<double> boardNm;  ///< StackupThickness
};

/// A layer names a Spec and a Material in it (SpecRef, MaterialSpecName, MaterialName); the material has a thickness
/// (Default_Thickness, the finished one first) and properties by frequency, of which the one the layer names counts,
/// else the first. Lengths without Units are in the file's DefaultUnits, else in mil. Text that is no such file gives
/// an empty stackup and a diagnostic; so does every reference to nothing.
[[nodiscard]] StackupXml parseStackupXml(std::string_view text, std::string_view path, Diagnostics& diagnostics);

/// Puts the file's numbers over those of the attributes and reports where they contradict. `layers` are those of
/// `facts.layers`. Dielectrics that the matrix has no row for add up under the copper above them; other layers that the
/// matrix does not have are reported.
void mergeStackupXml(const StackupXml& xml, std::string_view path, const std::vector<Layer>& layers,
                     StackupFacts& facts, Diagnostics& diagnostics);

}  // namespace model::odb
