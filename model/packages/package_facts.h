#pragma once

#include <string>
#include <vector>

#include "model/board/document.h"
#include "model/geometry/discretise.h"

namespace model {

inline constexpr Nm kMm = 1'000'000;

/// A length times a factor, rounded.
[[nodiscard]] Nm scaled(std::int64_t length, double factor);

/// A pin as the shape of a body follows from it, in package coordinates.
struct PinFacts {
    Point position;
    Box pad;  ///< of its land pattern; a box of half a millimetre around it where the job draws none
    bool isThrough = false;
};

/// What a job says of the outline of a package.
enum class OutlineSource : std::uint8_t {
    None,
    Drawn,
    Stated,  ///< a box only
    Dot      ///< some programs write one where they know no outline (odb-notes, Nets and parts)
};

/// All that is known of the package of a component before anything is concluded from it. Lengths are nanometres.
struct PackageFacts {
    std::string refdes;
    std::string name;  ///< of the package; a hint only
    std::vector<PinFacts> pins;
    std::size_t firstPin = 0;  ///< row of pin 1 (A1); 0 if none is called so
    /// What the job draws as the outline: of the body, of body and leads, or a courtyard around both. Empty unless
    /// that is Drawn.
    PolygonSet outline;
    OutlineSource outlineSource = OutlineSource::None;
    Box box;            ///< around the outline; what the job states where it draws none; empty if neither
    Nm boardDepth = 0;  ///< from the face it stands on to the other face of the board

    /// Without a box of its pad it gets the assumed one.
    void addPin(Point position, const Box& pad, bool isThrough);
    /// `drawn` is the box of the outline, `stated` what is taken where none is drawn. To be called after the pins.
    void setOutline(PolygonSet polygons, const Box& drawn, const Box& stated);

    [[nodiscard]] Box boxOfPads() const;
    /// Around the middles of the pins.
    [[nodiscard]] Box boxOfPins() const;
};

/// Of a component in package coordinates, or in those of the board where its package is not known.
[[nodiscard]] PackageFacts factsOf(const Document& document, const Component& component);

/// Is it the name that programs give to the first pin?
[[nodiscard]] bool isFirstPin(std::string_view name);

}  // namespace model
