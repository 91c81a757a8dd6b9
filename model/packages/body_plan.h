#pragma once

#include <map>
#include <tuple>

#include "model/packages/body_size.h"

namespace model {

/// What a part of a body is made of, which is what it looks like.
enum class BodyMaterial : std::uint8_t {
    Moulding,  ///< black plastic; drawn in the colour of the layer
    Resistor,
    Ceramic,
    Tantalum,
    Ferrite,
    Lens,
    Housing,
    Metal,  ///< tin, aluminium
    Gold,
    Print,     ///< on what is dark
    DarkPrint  ///< on what is light
};
inline constexpr std::size_t kBodyMaterialCount = static_cast<std::size_t>(BodyMaterial::DarkPrint) + 1;

/// Print is so thick that it is seen from any distance at which it can be read.
inline constexpr Nm kPrint = 20'000;

/// What can be read on a material.
[[nodiscard]] constexpr BodyMaterial printOn(BodyMaterial material) {
    const bool isLight = material == BodyMaterial::Housing || material == BodyMaterial::Metal ||
                         material == BodyMaterial::Lens || material == BodyMaterial::Tantalum ||
                         material == BodyMaterial::Gold;
    return isLight ? BodyMaterial::DarkPrint : BodyMaterial::Print;
}

/// Upright prisms of one material, in package coordinates. Heights are from the face of the board the component stands
/// on, upwards; below 0 it reaches into the board and through it.
struct BodyPart {
    PolygonSet polygons;
    Nm bottom = 0;
    Nm top = 0;
    BodyMaterial material = BodyMaterial::Moulding;
};

/// What a component looks like, as prisms.
struct BodyPlan {
    PackageFamily family = PackageFamily::None;
    OutlineSource outlineSource = OutlineSource::None;
    bool isAsDrawn = false;  ///< the box is that of the drawn outline
    PolygonSet outline;      ///< of the body without its leads
    Box box;                 ///< around it; empty: there is no body
    Nm height = 0;           ///< of all of it
    bool isHeightAssumed = true;
    Nm bodyTop = 0;  ///< of the prism over the outline; less than `height` where pins stand out of a housing
    BodyMaterial material = BodyMaterial::Moulding;
    std::vector<BodyPart> parts;  ///< all but the body itself: leads, terminals, pins, the mark of pin 1
    Box label;                    ///< where the designator is printed; empty: nowhere
};

/// `statedHeight` is the job's; 0 or less: it states none.
[[nodiscard]] BodyPlan planBody(const PackageFacts& facts, Nm statedHeight);

/// The plans of the components of a document, each made once for all components of a package that are of one kind by
/// their names and as high. Not thread-safe.
class BodyPlans {
public:
    explicit BodyPlans(const Document& document) : m_document(document) {}
    /// Stays where it is.
    [[nodiscard]] const BodyPlan& of(ComponentId component);

private:
    /// Package, kind, isJumperName and stated height; the component itself where its package is not known.
    using Key = std::tuple<std::uint32_t, std::uint32_t, PartKind, bool, Nm>;

    const Document& m_document;
    std::map<Key, BodyPlan> m_plans;
};

}  // namespace model
