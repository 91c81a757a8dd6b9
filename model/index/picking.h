#pragma once

#include <memory>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "model/index/board_index.h"

namespace model {

/// A layer as a view draws it.
struct PickLayer {
    bool isVisible = false;
    double bottom = 0.0;  ///< nm, as drawn (exploded, exaggerated); `top` is not below it
    double top = 0.0;
    bool isSeenThrough = false;  ///< hides nothing that lies beneath
    double faces = 0.0;          ///< nm, heights of the board's faces as drawn, added: what is mirrored is drawn at
                                 ///< this minus where its layer is
};

/// Where an element of a copy is drawn, whatever the heights of its layer: as high as that is, mirrored through the
/// board where a flipped copy has no layer to lie on, or, a component's body, as high as this is from the face it
/// stands on.
struct ElementHeights {
    bool isMirrored = false;          ///< isMirroredInCopy
    std::optional<double> body = {};  ///< nm, how high it is
    bool growsDown = false;           ///< bodies: from the upper face of their layer

    /// Lower and upper end, nm. `drawn`: Document::layerOfCopy, as upright copies are drawn.
    [[nodiscard]] std::pair<double, double> on(const PickLayer& drawn) const;
};
[[nodiscard]] ElementHeights elementHeights(const Document& step, ElementId element, bool isFlipped);

/// What is left of a board that is cut by a section plane: what does not lie beyond a line.
struct CutSide {
    PointD at;
    PointD outward;  ///< across the line, to what is gone
};

/// Lines of sight in nanometres of the board, z up.
struct SightLine {
    PointD origin;
    double z = 0.0;
    PointD direction;
    double down = 0.0;                 ///< how much z falls per step along the line; negative when looking up
    std::optional<CutSide> cutSide{};  ///< none: the board is whole
};

struct Hit {
    BoardElement at;
    LayerId layer;        ///< of the board, where a flipped copy has put it
    double depth = 0.0;   ///< steps along the line of sight; in 2D how far its layer is below the nearest one, nm
    double missedBy = 0;  ///< nm; 0 where the element covers the location
    double size = 0.0;    ///< diagonal of its box, nm
    bool isPad = false;   ///< a pad or a hole
};

/// Which elements a location of the board shows, from the exact geometry: arcs are arcs, holes are filled as far as the
/// drill reaches. The result is a list from what is seen first to what lies beneath, so that repeated clicks walk
/// through it: what covers the location before what only comes near, nearer layers before farther ones, in one plane
/// pads and holes before tracks and areas, which may end within them or lie beneath, then the smaller before the larger
/// and then what was drawn later. Equal input gives equal order.
class Picker {
public:
    explicit Picker(std::shared_ptr<const BoardIndex> index) : m_index(std::move(index)) {}

    /// `layers` has one entry per layer of the board; `reach` is how far beside an element a location still counts.
    [[nodiscard]] std::vector<Hit> at(PointD location, double reach, std::span<const PickLayer> layers,
                                      bool isFromBelow) const;
    [[nodiscard]] std::vector<Hit> along(const SightLine& line, double reach, std::span<const PickLayer> layers) const;
    /// Elements of visible layers that lie inside of the box, or with `isTouching` share a location with it, in the
    /// order of copies and ids.
    [[nodiscard]] std::vector<BoardElement> inside(const Box& box, bool isTouching,
                                                   std::span<const PickLayer> layers) const;

    /// Elements of these nets are not there; per row of StepTree::steps one entry per net, short lists are filled up.
    void hideNets(std::vector<std::vector<bool>> nets) { m_hiddenNets = std::move(nets); }

    [[nodiscard]] const BoardIndex& index() const { return *m_index; }

private:
    struct Probe;
    [[nodiscard]] bool isHidden(std::uint32_t step, ElementId element) const;
    void collect(const Probe& probe, std::vector<Hit>& hits) const;

    std::shared_ptr<const BoardIndex> m_index;
    std::vector<std::vector<bool>> m_hiddenNets;
};

}  // namespace model
