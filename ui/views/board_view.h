#pragma once

#include <QTimer>
#include <QWidget>
#include <functional>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "ui/canvas/camera_controller.h"
#include "ui/canvas/gpu_context.h"
#include "ui/canvas/picture.h"
#include "ui/views/board_position.h"
#include "ui/workspace/background.h"

class QPainter;

namespace ui {

class ImageCanvas;
class VulkanCanvas;
struct ViewShot;

/// A viewport: a camera, its input, and a canvas of the kind the platform can show. Draws only when something changed,
/// and once however much changed since the last frame. Where frames are slow (software Vulkan), outlines are coarser
/// and edges not smoothed while the view moves, and are again as soon as it rests. A 2D view looks straight at the
/// board with flat colours, a 3D view from anywhere.
class BoardView : public QWidget {
    Q_OBJECT

public:
    enum class Kind { Flat, Solid };  ///< 2D, 3D
    /// Paints over the board, in logical pixels of the canvas.
    using Painter = std::function<void(QPainter&)>;
    enum class Shown { Everywhere, OnCanvas };  ///< the latter not in pictures that are saved

    BoardView(GpuContext& context, Kind kind, QWidget* parent = nullptr);
    ~BoardView() override;

    /// Shows a scene, which the caller keeps alive until it sets another one; null shows the background. `styles` has
    /// one entry per layer. The camera is the caller's affair.
    void setScene(render::BoardScene* scene, std::vector<render::LayerStyle> styles);
    /// What the scene was made from: flat views of it are drawn without the device where that is no graphics card.
    /// Before `setScene`; null ends it.
    void setModel(std::shared_ptr<const render::BoardModel> model);
    /// Where the board model lies in the job.
    void setPosition(const BoardPosition& position) { m_position = position; }
    [[nodiscard]] const BoardPosition& position() const { return m_position; }
    /// Of a 2D view: the location on the board at a pixel, and the box between two pixels; in nm.
    [[nodiscard]] base::PointD locationAt(QPointF pixel) const {
        return m_position.toJob(m_controller.rayAt(pixel).origin);
    }
    [[nodiscard]] base::Box boxBetween(QPointF from, QPointF to) const;
    /// Where a location is on the canvas, at the height of the board's lower face; none behind the eye.
    [[nodiscard]] std::optional<QPointF> screenOf(base::PointD nm) const {
        return m_controller.screenOf(m_position.toModel(nm));
    }
    /// Box of the board in model millimetres, before explosion.
    void setBoard(const glm::vec3& boxMin, const glm::vec3& boxMax);
    void setStyles(std::vector<render::LayerStyle> styles);
    void setBackend(render::Backend backend);
    /// Darkens what does not stand out, see render::ViewSettings; from the next frame of the board on.
    void setDim(float dim) { m_picture.settings.dim = dim; }
    /// Outlines and nothing in them; in 2D.
    void setOutlined(bool isOn);
    /// Without what a fabricator mills away (render::ViewSettings::isFabricated): how a 3D view begins.
    void setFabricated(bool isOn);
    [[nodiscard]] const glm::vec3& background() const { return m_picture.settings.background; }  ///< sRGB, 0 to 1
    [[nodiscard]] bool isFabricated() const { return m_picture.settings.isFabricated; }
    /// Painters paint in the order in which they were added, before every frame.
    void addPainter(Painter painter, Shown shown = Shown::Everywhere) {
        m_painters.emplace_back(std::move(painter), shown);
    }
    /// Where something is painted that no label is to cover, in logical pixels; empty while nothing is.
    void addCorner(std::function<QRectF()> place) { m_corners.push_back(std::move(place)); }
    [[nodiscard]] std::vector<QRectF> corners() const;
    /// Paints before all others that were added so far.
    void addGroundPainter(Painter painter) {
        m_painters.emplace(m_painters.begin(), std::move(painter), Shown::Everywhere);
    }
    /// Paints before all others what lies in a level plane of the board, whose height as drawn (mm) `height` says;
    /// none: there is nothing to paint. In 3D what is opaque and nearer to the viewer hides it. One at most.
    void setPlanePainter(Painter painter, std::function<std::optional<float>()> height);
    /// 0 to 1, see render::ViewSettings.
    void setExplode(float explode);
    /// The caller sets a box of these heights too.
    void setZScale(const render::ZScale& scale);
    /// Cuts the board open (3D); null: it is whole.
    void setCut(std::shared_ptr<const render::SectionCut> cut);
    [[nodiscard]] const render::SectionCut* cut() const { return m_picture.settings.section.get(); }
    void requestFrame();
    /// Of the board, but where that is slow only when nothing has been asked for for a while, and an overlay at once.
    void requestFrameAtRest();
    /// The painters paint something else, all else is as it was: the board is not drawn again.
    void requestOverlay();
    /// Keys go to the canvas from now on.
    void takeKeyboard();
    [[nodiscard]] bool hasKeyboard() const;

    [[nodiscard]] bool hasScene() const { return m_picture.scene != nullptr; }
    [[nodiscard]] Kind kind() const { return m_kind; }
    [[nodiscard]] CameraController& controller() { return m_controller; }
    [[nodiscard]] const CameraController& controller() const { return m_controller; }
    [[nodiscard]] const std::vector<render::LayerStyle>& styles() const { return m_picture.styles; }
    /// Where layers are drawn, in millimetres; empty without a scene.
    [[nodiscard]] std::vector<render::ZRange> drawnHeights() const;
    /// Likewise render::BoardScene::drawnFaces; 0 without a scene.
    [[nodiscard]] float drawnFaces() const;
    /// Likewise the face of the board that is seen: the outer side of the copper nearest to the viewer; 0 without
    /// copper.
    [[nodiscard]] float seenFace(const model::Document& board) const;
    /// Frames take long: what is not asked for should not be drawn.
    [[nodiscard]] bool isSlow() const { return m_isSlow; }
    /// The widget or window that takes the input.
    [[nodiscard]] QObject& canvas();
    /// Pixels of the canvas times `scale`.
    [[nodiscard]] QSize pixelsOf(double scale) const { return (QSizeF(size()) * devicePixelRatioF() * scale).toSize(); }
    /// What the canvas shows at rest, in its size times `scale`, for pictures that are drawn later.
    [[nodiscard]] ViewShot shot(double scale = 1.0) const;
    /// The picture of that; waits for it. Errors: BadUsage, DeviceFailed.
    [[nodiscard]] base::Result<QImage> grabPicture(double scale = 1.0);
    /// Gives up what was made from the device, before it is renewed.
    void releaseDevice();
    /// Takes the canvas that suits the device: one that the device presents to, where it is no software device and the
    /// platform has surfaces; else one that shows pictures from memory and waits for nothing. After it was renewed.
    void takeCanvas();

signals:
    void drawn();
    /// How long the last frame of the board took, once that is known; also after frames of the overlay alone, which
    /// tell nothing new.
    void timed(const render::FrameStats& stats);
    void deviceLost();

private:
    void showVulkanCanvas();
    void showImageCanvas();
    void replaceCanvas(QWidget* canvas);
    void requestMovingFrame();
    void requestRestingFrame();
    void onTimed(const render::FrameStats& stats);
    void updateBox();
    void paintOverlay(QSize pixels);
    void scaleToLogical(QPainter& painter, QSize pixels) const;
    void paintAll(QPainter& painter, Shown where) const;
    void paintPlane(QSize pixels);
    [[nodiscard]] std::optional<float> planeHeight() const { return m_planeHeight ? m_planeHeight() : std::nullopt; }
    /// On a cleared image of this size, in logical pixels.
    template <class Paint>
    void paintOn(QImage& image, QSize pixels, const Paint& paint) const;

    GpuContext& m_context;
    Kind m_kind;
    CameraController m_controller;
    BoardPosition m_position;
    std::vector<std::pair<Painter, Shown>> m_painters;
    std::vector<std::function<QRectF()>> m_corners;
    Painter m_planePainter;
    std::function<std::optional<float>()> m_planeHeight;
    Picture m_picture;
    Background m_freeing;  ///< of the flat picture before: its tiles and outlines take longer than a frame
    glm::vec3 m_boxMin{-1.0F};
    glm::vec3 m_boxMax{1.0F};
    VulkanCanvas* m_window = nullptr;  ///< at most one of the two; owned by its container
    ImageCanvas* m_image = nullptr;
    QWidget* m_container = nullptr;
    QTimer m_rest;                ///< runs out when the view has not moved for a while
    bool m_isBoardDrawn = false;  ///< as it is to be seen, by the last frame, which may not be shown yet
    bool m_isSlow = false;        ///< a frame of this scene took longer than an eye blinks away
};

}  // namespace ui
