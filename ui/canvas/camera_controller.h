#pragma once

#include <QMarginsF>
#include <QObject>
#include <QPointF>
#include <QSizeF>
#include <functional>
#include <optional>
#include <utility>
#include <vector>

#include "model/base/units.h"
#include "render/scene/camera.h"

class QEvent;
class QKeyEvent;
class QMouseEvent;
class QWheelEvent;

namespace ui {

/// What the wheel does while Shift or Ctrl is held.
enum class WheelMove : std::uint8_t { UpAndDown, Sideways, Zoom };

/// What drags of the right button do otherwise than pan, and what the wheel does otherwise than zoom.
struct MouseHabits {
    bool rightDragZooms = false;        ///< in a plan: into a box, or out of it; with Shift it pans
    bool shiftRightDragOrbits = false;  ///< but in a plan, where it pans
    WheelMove shiftWheel = WheelMove::UpAndDown;
    WheelMove ctrlWheel = WheelMove::Sideways;
};

/// Turns mouse, wheel and arrow keys into camera moves; knows nothing of the kind of widget that receives them.
/// Positions are logical pixels.
///
/// Left drag orbits; middle drag, right drag or Shift with left drag pans; the wheel zooms to the cursor, and with
/// Shift or Ctrl pans; arrows orbit and with Shift pan. A press that moves less than kClickPixels before its release is
/// a click and leaves the camera alone; a click of the right button asks for a menu. The second press of a double click
/// is no click. In a plan nothing orbits: left drag draws a box, which Esc gives up, and arrows pan, and the board
/// moves by whole pixels of the screen, so that its picture stays as it is.
class CameraController : public QObject {
    Q_OBJECT

public:
    static constexpr double kClickPixels = 4.0;
    static constexpr float kZoomPerNotch = 1.2F;

    using QObject::QObject;

    void setHabits(const MouseHabits& habits) { m_habits = habits; }
    /// Looks straight at the board and stays so: parallel, from above or below.
    void setPlan();
    [[nodiscard]] bool isPlan() const { return m_isPlan; }
    /// A button is held down.
    [[nodiscard]] bool isDragging() const { return m_button != Qt::NoButton; }
    /// Until the user moves the camera, the board is fitted again whenever viewport or box change.
    /// `pixelRatio`: pixels of the screen per logical one.
    void setViewport(QSizeF size, double pixelRatio = 1.0);
    /// Pixels along the edges that something else covers: what is fitted or shown stays clear of them. In a plan.
    void setMargins(const QMarginsF& margins);
    [[nodiscard]] const QMarginsF& margins() const { return m_margins; }
    /// The box `fit` shows, in board model millimetres.
    void setBox(const glm::vec3& boxMin, const glm::vec3& boxMax);

    void fit();
    void look(render::NamedView view);
    /// The same, but in a plan that shows a part of the board from the other side, that part stays: flip.
    void lookAtSide(render::NamedView side);
    /// Looks at the other side of the board, at what is in the middle of the canvas now.
    void flip();
    /// Brings a part of the board to the middle, and as large as fills 80 % of the canvas, but no smaller parts than
    /// can be made out with their surroundings.
    void show(const glm::vec3& boxMin, const glm::vec3& boxMax);
    void setOrthographic(bool isOrthographic);
    /// Follows what is looked at up by so many millimetres; not while all of the board is shown.
    void lift(float mm);
    /// Looks as told; a plan stays straight.
    void setPose(const render::CameraPose& pose);
    /// The same with a pose of a viewport of that aspect (width through height): where this one is narrower, from so
    /// far away that as much is seen across, also when the viewport changes until the camera moves.
    void restore(const render::CameraPose& pose, float aspect);
    [[nodiscard]] float aspect() const { return static_cast<float>(m_viewport.width() / m_viewport.height()); }
    /// Zooms by `factor` (> 1 is closer) and keeps the point of the board at `position` where it is on the screen, or
    /// beside the board the point of it that is nearest: a board that is seen stays in sight.
    void zoomAt(QPointF position, float factor);
    void zoomAtCentre(float factor) { zoomAt(centre(), factor); }
    /// Zooms until a box of the canvas fills it, or drawn to another corner than the lower right one, until the canvas
    /// fits into the box.
    void zoomToBox(QPointF from, QPointF to);

    /// Looks at the board from a side, an edge or a corner of it (x right, y up, z above the top), at what is in the
    /// middle of the canvas now; all of the board stays in sight if it was shown whole.
    void lookFrom(const glm::vec3& side);
    /// Turns the board as a drag of so many pixels does.
    void orbit(QPointF pixels);

    /// Something over the canvas that gets mouse events first; true: it was for that and is over. Who was added first
    /// is asked first.
    using Taker = std::function<bool(QEvent&)>;
    void addTaker(Taker taker) { m_takers.push_back(std::move(taker)); }
    /// Takes the event if it is one of the gestures above; the answer says so.
    bool handle(QEvent& event);

    [[nodiscard]] const render::Camera& camera() const { return m_camera; }
    /// Does such a camera see all of the board?
    [[nodiscard]] bool seesAll(const render::Camera& camera) const;
    /// Looks in the same direction, from where all of the board is seen.
    [[nodiscard]] render::Camera cameraForAll() const;
    /// Where the line of sight through `position` meets the face of the board turned to the viewer; none if it misses
    /// the board.
    [[nodiscard]] std::optional<glm::vec3> boardPointAt(QPointF position) const;
    /// The line of sight through `position`.
    struct Ray {
        glm::vec3 origin;
        glm::vec3 direction;
    };
    [[nodiscard]] Ray rayAt(QPointF position) const;
    /// Where a point of the board is on the canvas; none behind the eye.
    [[nodiscard]] std::optional<QPointF> screenOf(const glm::vec3& point) const;
    /// From millimetres of the board model to clip space, y down as Vulkan has it.
    [[nodiscard]] glm::mat4 clipFromBoard() const { return m_camera.projection(aspect()) * m_camera.view(); }
    /// Millimetres per logical pixel at the target.
    [[nodiscard]] float mmPerPixel() const { return m_camera.mmPerPixel(height()); }
    [[nodiscard]] double nmPerPixel() const { return static_cast<double>(mmPerPixel()) * base::kNmPerMm; }
    [[nodiscard]] QSizeF viewport() const { return m_viewport; }

signals:
    /// The camera changed: draw again.
    void moved();
    void clicked(QPointF position, Qt::KeyboardModifiers modifiers);
    /// With the left button; the first of the two was `clicked`.
    void doubleClicked(QPointF position, Qt::KeyboardModifiers modifiers);
    /// A click of the right button.
    void menuRequested(QPointF position);
    /// The cursor rests or moves over the canvas with no button down; `left` when it goes away.
    void hovered(QPointF position);
    void left();
    /// A box being drawn, and the same once it is done. In a drawn box left and right may be exchanged.
    void boxDrawn(QPointF from, QPointF to);
    void boxFinished(QPointF from, QPointF to, Qt::KeyboardModifiers modifiers);
    /// The box that was drawn was one to zoom to, and is gone.
    void zoomedToBox();
    /// The box that was drawn is gone, and nothing comes of it.
    void boxGivenUp();
    /// A button, a wheel or a key: this is the canvas in use.
    void used();

private:
    enum class Drag { None, Undecided, Orbit, Pan, Box, ZoomBox };

    [[nodiscard]] Drag kindOf(const QMouseEvent& event) const;
    bool press(const QMouseEvent& event);
    bool doubleClick(const QMouseEvent& event);
    bool move(const QMouseEvent& event);
    bool release(const QMouseEvent& event);
    bool wheel(const QWheelEvent& event);
    [[nodiscard]] WheelMove moveOf(const QWheelEvent& event) const;
    bool keepKey(QKeyEvent& event) const;
    bool key(const QKeyEvent& event);
    [[nodiscard]] bool givesUpBox(const QKeyEvent& event) const;
    bool dispatch(QEvent& event);
    void orbitBy(QPointF pixels);
    QPointF panBy(QPointF pixels);
    void place(const render::CameraPose& pose);
    void seeAsMuch();
    void announceUserMove();
    void focusAt(QPointF position);
    template <class Place>
    void placeInMargins(const Place& place);
    [[nodiscard]] QPointF pivotAt(QPointF position);
    [[nodiscard]] std::optional<QPointF> nearestSeen(QPointF position) const;
    [[nodiscard]] glm::vec2 ndcOf(QPointF position) const;
    [[nodiscard]] QPointF centre() const { return {m_viewport.width() / 2.0, m_viewport.height() / 2.0}; }
    [[nodiscard]] float height() const { return static_cast<float>(m_viewport.height()); }

    render::Camera m_camera;
    glm::vec3 m_boxMin{-1.0F};
    glm::vec3 m_boxMax{1.0F};
    QSizeF m_viewport{1.0, 1.0};
    double m_pixelRatio = 1.0;
    QMarginsF m_margins;
    bool m_isFitted = true;
    struct Restored {
        render::CameraPose pose;
        float aspect = 1.0F;
        render::CameraPose taken;  ///< for the viewport that there is
    };
    std::optional<Restored> m_restored;
    bool m_isPlan = false;
    MouseHabits m_habits;
    std::vector<Taker> m_takers;
    Drag m_drag = Drag::None;
    Drag m_dragKind = Drag::None;  ///< what the drag becomes once it is one
    Qt::MouseButton m_button = Qt::NoButton;
    QPointF m_pressed;
    QPointF m_last;
};

}  // namespace ui
