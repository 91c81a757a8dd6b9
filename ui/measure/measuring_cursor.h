#pragma once

#include <optional>
#include <span>

#include "model/measure/edge_at.h"
#include "model/measure/local_spacing.h"
#include "model/measure/snapping.h"
#include "ui/views/probing.h"

namespace ui {

/// What a click is to catch.
enum class Catch {
    Points,    ///< centres, ends, middles, crossings and edges nearby, else the location itself
    Copper,    ///< such points on copper and plated holes alone, else the copper under the cursor
    Elements,  ///< the element under the cursor, of a hole its pad; or the board's edge, in 2D
    Straight,  ///< the straight track or side under the cursor
    Round      ///< the circle or arc under the cursor
};

/// What the cursor points at.
struct Caught {
    base::PointD at;  ///< nm of the board
    model::SnapKind kind = model::SnapKind::Free;
    model::LayerId layer;                        ///< of the board
    std::optional<model::BoardElement> element;  ///< none: a location without one
    bool isOnEdge = false;                       ///< of the board: such a location
    std::optional<model::Edge> line{};           ///< of Catch::Straight
    std::optional<model::Round> round{};         ///< of Catch::Round
    bool isInPlan = false;                       ///< in a 2D view
};

/// Finds what may be measured under a cursor, in both views. In 3D only the layer that is seen at the cursor counts.
class MeasuringCursor {
public:
    static constexpr double kCatchPixels = 14.0;

    explicit MeasuringCursor(Probing& probing) : m_probing(probing) {}

    void setBoard(std::shared_ptr<const model::BoardIndex> index);

    /// Nothing if there is nothing of that kind. Points are those that are seen; a location without one is of the
    /// copper that is seen there. With Alt held no points are snapped to; with a `first` click before, Shift keeps
    /// points straight beside or above it, and Ctrl to steps of 45 degrees. Of elements Alt catches the hole in a pad;
    /// and where the one that is seen is that of `first`, the next beneath it that is another piece of copper is caught
    /// instead, like a pad under a plane, or the same one again if there is none. What `step` leads to is caught as it
    /// is.
    [[nodiscard]] std::optional<Caught> at(const BoardView& view, QPointF position, Catch what,
                                           Qt::KeyboardModifiers modifiers = {}, const Caught* first = nullptr);
    /// The next point or element beneath the one that is caught (1), or the one before (-1); until the cursor moves.
    void step(int by);
    /// Ends that: what is seen is caught next.
    void stopStepping() { m_skip = 0; }
    /// An element under the cursor that covers nothing, so that nothing above finds it.
    [[nodiscard]] std::optional<model::BoardElement> emptyAt(const BoardView& view, QPointF position);
    /// Is the cursor over the board?
    [[nodiscard]] bool isOnBoard(const BoardView& view, QPointF position) {
        return pointedAt(view, position, Catch::Points).has_value();
    }
    /// See model::spacingAt: on the layer of the pad or track under the cursor. Elsewhere, also over a plane, which may
    /// be what is seen between copper, all visible layers count, and so they do where solder mask or dielectric is
    /// seen.
    [[nodiscard]] std::optional<model::LocalSpacing> spacingAt(const BoardView& view, QPointF position);

private:
    /// A location of the board under the cursor, and what is seen there.
    struct Pointed {
        base::PointD location;
        std::optional<model::Hit> hit;  ///< none: nothing to snap to
        bool isFromBelow = false;
    };

    /// Where on the board something lies that the cursor is over.
    [[nodiscard]] static base::PointD seenAt(const BoardView& view, QPointF position, const model::Hit& hit);
    [[nodiscard]] std::optional<Pointed> pointedAt(const BoardView& view, QPointF position, Catch what);
    [[nodiscard]] bool isWanted(const model::Hit& hit, base::PointD location, double reach, Catch what);
    [[nodiscard]] bool isNetCopper(model::BoardElement at) const;
    [[nodiscard]] bool isArea(model::BoardElement at) const;
    [[nodiscard]] std::optional<Caught> pointAt(const BoardView& view, const Pointed& pointed, Catch what,
                                                bool isSnapping);
    /// The copper that is seen at a location without a point, in 2D.
    void findCopper(const BoardView& view, QPointF position, Caught& caught);
    [[nodiscard]] Caught elementAt(const Pointed& pointed, double reach, Catch what);
    /// The board's edge, where nothing but a drawing lies over it.
    [[nodiscard]] std::optional<Caught> edgeAt(const BoardView& view, const Pointed& pointed) const;
    /// What may be caught of Catch::Elements, that without a step first: the board's edge and elements, each once, a
    /// pad before the hole in it unless `takesHoles`.
    [[nodiscard]] std::vector<Caught> elementsAt(const BoardView& view, QPointF position, bool takesHoles,
                                                 const Caught* first);
    /// The pad of a plated hole that is seen; none of anything else.
    [[nodiscard]] std::optional<model::Hit> padAround(const model::Hit& hole, std::span<const model::Hit> hits) const;
    /// The hole of such a pad, wherever the current layer has put it.
    [[nodiscard]] std::optional<model::Hit> holeIn(const model::Hit& pad, std::span<const model::Hit> hits) const;
    /// The first copper or hole beneath that is not one piece with what is seen: not of its net on its layer, nor
    /// joined to it by a hole. What is seen if there is none.
    [[nodiscard]] model::Hit beneath(std::span<const model::Hit> hits, const model::Hit& seen) const;
    [[nodiscard]] bool isHole(const model::BoardElement& at) const;
    /// On which layers points are snapped to.
    [[nodiscard]] std::vector<model::PickLayer> layersFor(const BoardView& view, const Pointed& pointed,
                                                          Catch what) const;
    [[nodiscard]] double reachIn(const BoardView& view) const;

    Probing& m_probing;
    std::shared_ptr<const model::BoardIndex> m_index;
    std::optional<model::Snapper> m_snapper;
    std::optional<model::Picker> m_picker;
    QPointF m_last;          ///< where the cursor was
    std::size_t m_skip = 0;  ///< points or elements better than the one wanted
    model::FigureTable m_boardEdge;
};

}  // namespace ui
