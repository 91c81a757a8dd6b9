#pragma once

#include <QFont>
#include <QStringList>
#include <memory>

#include "model/index/board_index.h"
#include "ui/common/kept_picture.h"
#include "ui/nets/net_styles.h"
#include "ui/views/board_position.h"
#include "ui/views/board_view.h"
#include "ui/workspace/workspace.h"

namespace ui {

/// What the 2D view shows over the board: a grid whose step follows the zoom, rulers along two edges, and the names of
/// nets and pins on copper that is large enough on the screen to hold them.
class PlanPainter : public QObject {
    Q_OBJECT

public:
    /// Paints over `view` from now on, which must live as long. What `styles` hides has no name.
    PlanPainter(BoardView& view, Workspace& workspace, const NetStyles& styles, QObject* parent = nullptr);

    void showGrid(bool isOn);
    void showNames(bool isOn);
    void showPinNames(bool isOn);

    /// The part of the board the view shows, in nm.
    [[nodiscard]] model::Box shownBox() const;
    /// The copper layer that can be made out and is drawn over the others: the current one, else the one nearest to the
    /// viewer; none if there is none.
    [[nodiscard]] model::LayerId namedLayer() const;
    /// Distance of grid lines in nm: 1, 2 or 5 times a power of ten of the unit, at least `pixels` apart.
    [[nodiscard]] static double gridStep(double nmPerPixel, LengthUnit unit, double pixels = 24.0);
    /// A name and the middle of the place it is written at, in canvas coordinates.
    struct Label {
        QPointF middle;
        double angleDeg = 0.0;
        double height = 0.0;  ///< of the letters, in pixels
        QString text;         ///< one line, or a pin and below it its net
    };
    /// Of `namedLayer`: names of what it hides would only confuse, and so would those of what bodies of components
    /// cover there. But what is selected or highlighted is seen through both: there its names are written, and no
    /// others. No two lie on one another: where they would, pads come before tracks. Copies of steps count, and cost as
    /// much as is seen of them.
    [[nodiscard]] std::vector<Label> labels() const;

    enum class Ruler { Upper, Left };
    /// A tick of a ruler, in canvas coordinates along it; without a number where that has no room.
    struct RulerTick {
        double at = 0.0;
        QString number;
    };
    /// With numbers in this font.
    [[nodiscard]] std::vector<RulerTick> ticks(Ruler ruler, const QFont& font) const;

    static constexpr int kRulerPixels = 18;     ///< how wide rulers are
    static constexpr double kBesideTick = 3.0;  ///< from a tick to its number, in the direction of reading

private:
    /// What rulers look like.
    struct RulerKey {
        model::Box box;
        QPointF corner;  ///< where its least coordinates are seen
        double step = 0.0;
        LengthUnit unit = LengthUnit::Millimetre;
        QSize size;
        QFont font;
        bool operator==(const RulerKey&) const = default;
    };

    void setBoard(const LoadedBoard& board);
    void paint(QPainter& painter) const;
    void paintGrid(QPainter& painter, double step) const;
    void paintRulers(QPainter& painter) const;
    [[nodiscard]] RulerKey rulerKey(const QFont& font) const;
    void paintUpperRuler(QPainter& painter, const RulerKey& key) const;
    void paintLeftRuler(QPainter& painter, const RulerKey& key) const;
    void paintNames(QPainter& painter) const;
    [[nodiscard]] bool isNamed(const model::BoardElement& at) const;
    [[nodiscard]] std::vector<model::BoardElement> namedElements() const;
    struct PlacedElement {
        model::BoardElement at;
        model::Box box;  ///< on the board
    };
    [[nodiscard]] std::vector<PlacedElement> standingOutBeneath() const;
    [[nodiscard]] bool liesOn(const Label& label, const std::vector<PlacedElement>& elements) const;
    [[nodiscard]] std::optional<Label> labelFor(const model::BoardElement& at) const;
    [[nodiscard]] QStringList pinNames(const model::BoardElement& at) const;
    [[nodiscard]] std::vector<QStringList> textsFor(const model::BoardElement& at) const;
    [[nodiscard]] QPointF screenOf(double x, double y) const;
    [[nodiscard]] model::Box placedBoxOf(const model::BoardElement& at) const;
    [[nodiscard]] QRectF screenBoxOf(const model::BoardElement& at) const;

    BoardView& m_view;
    Workspace& m_workspace;
    const NetStyles& m_styles;
    std::shared_ptr<const model::BoardIndex> m_index;
    mutable KeptPicture<RulerKey> m_upperRuler;  // letters take their time
    mutable KeptPicture<RulerKey> m_leftRuler;
    bool m_hasGrid = true;
    bool m_hasNames = true;
    bool m_hasPinNames = true;
};

}  // namespace ui
