#pragma once

#include <QElapsedTimer>
#include <QObject>
#include <QTimer>
#include <array>
#include <optional>

#include "model/index/picking.h"
#include "ui/layers/layer_model.h"
#include "ui/nets/net_styles.h"
#include "ui/views/board_position.h"
#include "ui/views/board_views.h"
#include "ui/views/milled_away.h"
#include "ui/workspace/background.h"
#include "ui/workspace/workspace.h"

namespace ui {

/// Between the pointer in the two views and the selection (ui/workspace/selection_model.h): hovering shows what an
/// element is, a click selects it, Ctrl adds, a box in 2D selects many. A click on what is selected, once a double
/// click is over, takes what lies beneath; so does Tab, and Shift+Tab what lies above. A double click keeps what was
/// selected there, or what its first click selected, and brings it to the middle of both views; Alt and a click brings
/// it to the middle of the other view (or of this one if it is alone). What stands out is seen in both views, always;
/// cameras move only when asked.
class Probing : public QObject {
    Q_OBJECT

public:
    static constexpr float kAroundMm = 1.5F;

    /// What `nets` hides is looked through.
    Probing(BoardViews& views, Workspace& workspace, NetStyles& nets, LayerModel& layers, QObject* parent = nullptr);

    /// Whether the camera of `to` follows what is clicked in the other view.
    void setFollows(BoardView::Kind to, bool isOn) { m_follows[static_cast<std::size_t>(to)] = isOn; }

    /// While something else takes the clicks, nothing is selected and no tips are shown.
    void setSelecting(bool isOn) { m_isSelecting = isOn; }
    [[nodiscard]] bool isSelecting() const { return m_isSelecting; }

    [[nodiscard]] const BoardPosition& position() const { return m_views.flat().position(); }
    /// What the view shows of each layer, nothing while it waits for the board; empty without one.
    [[nodiscard]] std::vector<model::PickLayer> layersOf(const BoardView& view) const;
    /// What the section plane of a view has taken; none: the board is whole there.
    [[nodiscard]] static std::optional<model::CutSide> cutSideOf(const BoardView& view);
    /// What lies under a location on the canvas, see model::Picker.
    [[nodiscard]] std::vector<model::Hit> hitsAt(const BoardView& view, QPointF position);
    /// Selects what a click there does, unless it is chosen already: what a menu is opened on. False where nothing
    /// lies.
    bool chooseAt(const BoardView& view, QPointF position);
    /// Brings elements to the middle.
    void show(BoardView& view, std::span<const model::BoardElement> elements);
    void showInBoth(std::span<const model::BoardElement> elements);
    /// Brings a location on a layer, or on the face of the board that is seen, to the middle of both views, in 2D with
    /// so much around it, and in 3D with a few millimetres.
    void showPosition(base::PointD nm, model::LayerId layer, float aroundMm = kAroundMm);

signals:
    /// The pointer is over a location on the board, in its coordinates in nm.
    void pointedAt(double x, double y);
    void pointedAway();
    /// Tab (1) or Shift+Tab (-1) while something else takes the clicks.
    void beneathWanted(int by);
    /// Ctrl+Shift and a click: the component of an element is wanted.
    void componentRequested(const model::BoardElement& at);

private:
    /// Keys are about what lies under the pointer when they are pressed, whether or not it has moved or rested there.
    bool eventFilter(QObject* object, QEvent* event) override;
    void setBoard(const LoadedBoard& board);
    void makeOutlines(const std::shared_ptr<const model::BoardIndex>& index);
    void watch(BoardView& view);
    void hideNets();
    void findPointer();
    void hover();
    void endStaleHover(BoardView& view);
    void endHiddenHover();
    void hoverAgain(const BoardView& view);
    void click(BoardView& view, QPointF position, Qt::KeyboardModifiers modifiers);
    void doubleClick();
    void selectFirst(const BoardView& view, QPointF position, std::vector<model::BoardElement> found);
    /// By 1 beneath, by -1 above what the last click took; false if that is not what is selected.
    bool selectBeneath(int by);
    [[nodiscard]] bool isLastSelected() const;
    [[nodiscard]] bool isCanvas(const QObject* object) const;
    void showInOther(BoardView& view);
    void selectBox(QPointF from, QPointF to, Qt::KeyboardModifiers modifiers);
    void announceLocation(const BoardView& view, QPointF position);
    void paintBox(QPainter& painter) const;

    BoardViews& m_views;
    Workspace& m_workspace;
    SelectionModel& m_selection;
    NetStyles& m_nets;
    std::optional<model::Picker> m_picker;
    Background m_outlines;  ///< fills model::FigureCache once a board has come
    MilledAway m_milledAway;
    std::array<bool, 2> m_follows{};
    bool m_isSelecting = true;

    QTimer m_rest;  ///< runs out when the cursor has stayed a moment
    BoardView* m_hoverView = nullptr;
    QPointF m_hoverAt;
    std::optional<std::pair<QPointF, QPointF>> m_box;  ///< being drawn in 2D

    /// Where the last click was and what it found, so that the next one there takes what lies beneath.
    struct LastClick {
        const BoardView* view = nullptr;
        QPointF position;
        std::vector<model::BoardElement> found;
        std::size_t taken = 0;
        bool isBeneath = false;  ///< it took what lies beneath, which a double click takes back
        QElapsedTimer since;
    } m_last;
};

}  // namespace ui
