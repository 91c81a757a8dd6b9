#pragma once

#include <QObject>
#include <QTimer>
#include <array>
#include <optional>
#include <vector>

#include "model/index/picking.h"
#include "ui/common/kept_picture.h"
#include "ui/views/board_views.h"
#include "ui/views/outline_strokes.h"
#include "ui/workspace/workspace.h"

namespace ui {

class NetStyles;

/// Draws the outlines of the element under the pointer, and of what is selected or near it, over both views. They are
/// painted, not drawn by the device, so that they need not wait for a frame of the board: where frames are slow they
/// would lag behind the pointer. They also show where something lies that other layers cover; but what lies on a hidden
/// layer, is of a hidden net or is cut away has none. Bodies of components are outlined at their own height.
class ElementOutlines : public QObject {
    Q_OBJECT

public:
    /// More elements than these are not outlined: that would take too long, and they are seen as it is.
    static constexpr std::size_t kMostOutlined = 500;
    /// Nodes of all that is selected. Elements beyond this go without an outline, those before them have theirs.
    static constexpr std::size_t kMostNodes = 400'000;
    /// So few have chords as short as can be: who looks at a small clearance sees how far usual ones are off their
    /// curves.
    static constexpr std::size_t kMostFine = 8;
    /// Points of all that is selected. Where there are more, their outlines come right after the frame in which it
    /// stands out: they take half as long as that frame.
    static constexpr std::size_t kMostAtOnce = 256;

    /// Of one element.
    struct Outline {
        OutlineRuns runs;
        model::LayerId layer;  ///< of the board, where the element is drawn
        model::ElementHeights heights;
        std::optional<model::BoardNet> net = std::nullopt;
        bool isNear = false;  ///< to what is selected; in another colour than that
    };

    ElementOutlines(BoardViews& views, Workspace& workspace, const NetStyles& nets, QObject* parent = nullptr);

    /// No loops while nothing is hovered, and until the next event where it is large.
    [[nodiscard]] const Outline& hovered() const { return m_hovered; }
    /// Of the elements selected, those near them, and those marked.
    [[nodiscard]] const std::vector<Outline>& selected() const { return m_selected; }
    /// What is painted over a view as it is now; without what is selected while that waits for a frame.
    [[nodiscard]] OutlineStrokes strokesOver(const BoardView& view) const;

private:
    /// What is painted over a view.
    struct Looks {
        std::uint64_t change = 0;  ///< of what is outlined
        glm::mat4 clipFromBoard{1.0F};
        QSizeF viewport;
        std::vector<render::ZRange> heights;
        std::vector<bool> visibility;  ///< of layers
        std::optional<render::SectionPlane> cut;
        bool operator==(const Looks&) const = default;
    };

    void watch(BoardView& view, std::optional<QPointF>& pointer);
    void updateHovered();
    void showHovered();
    void updateSelected();
    void showSelected();
    [[nodiscard]] Outline outlineOf(const model::BoardElement& at, std::size_t& pointsToUnite, bool isFine) const;
    [[nodiscard]] std::size_t rowOf(const BoardView& view) const { return &view == m_views.both()[0] ? 0 : 1; }
    [[nodiscard]] Looks looksOf(const BoardView& view) const;
    void paint(QPainter& painter, const BoardView& view);
    void paintOrKeep(QPainter& painter, const BoardView& view, const Looks& looks);
    static void paintStrokes(QPainter& painter, const OutlineStrokes& strokes);

    BoardViews& m_views;
    SelectionModel& m_selection;
    const NetStyles& m_nets;
    Outline m_hovered;
    QTimer m_hoveredDue;  ///< runs while the outline of what is hovered is still to be made
    std::vector<Outline> m_selected;
    bool m_isSelectedLate = false;                     ///< its outlines wait for a frame without them
    QTimer m_afterFrame;                               ///< runs once there was one
    std::array<std::optional<QPointF>, 2> m_pointers;  ///< over each of the views
    std::uint64_t m_change = 0;
    struct OnView {
        std::optional<Looks> painted;  ///< the last time, without a picture
        KeptPicture<Looks> picture;
    };
    std::array<OnView, 2> m_onViews;
    QTimer m_rest;            ///< runs while what is painted may soon be another
    bool m_isAtRest = false;  ///< what is large becomes a picture when it is painted again
};

}  // namespace ui
