#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>

#include "model/board/document.h"
#include "model/formats/ipc2581/reading.h"

namespace model::ipc2581 {

/// What a Spec says of a material or a hole.
struct Spec {
    std::string material;
    std::optional<double> dielectricConstant;
    std::optional<double> lossTangent;
    std::optional<double> resistivity;  ///< nΩ·m
    std::optional<double> copperOz;
    bool isBackdrill = false;
};

/// The Specs of the CadHeader.
class Specs {
public:
    explicit Specs(Reading& reading);

    /// The spec that a SpecRef means; nullptr if there is none, which is reported. KiCad refers to `SPEC_F.Cu` where it
    /// defines `F.Cu_1`: such a prefix and number are forgiven, and reported.
    [[nodiscard]] const Spec* find(const XmlCursor& reference) const;
    /// Adds what it says to a material.
    static void describe(const Spec& spec, bool isCopper, Material& material);

private:
    Reading& m_reading;
    std::unordered_map<std::string_view, Spec> m_specs;
    std::unordered_map<std::string_view, const Spec*> m_unnumbered;  ///< by names without their number
};

}  // namespace model::ipc2581
