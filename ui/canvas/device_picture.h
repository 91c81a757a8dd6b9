#pragma once

#include <QImage>
#include <QObject>
#include <QTimer>
#include <future>
#include <optional>

#include "ui/canvas/gpu_context.h"
#include "ui/canvas/picture.h"

namespace ui {

/// Pictures of a board by a device that takes its time: the window goes on meanwhile, and is told when one is there.
class DevicePicture : public QObject {
    Q_OBJECT

public:
    /// The last picture, without the overlay; null: none.
    struct Shot {
        QImage image;  ///< Format_RGB32
        render::Camera camera;
        render::FrameStats stats;
    };

    DevicePicture(GpuContext& context, const Picture& picture, QObject* parent = nullptr);
    ~DevicePicture() override;

    /// Has the device draw a picture as soon as it is its turn; after the one it draws. True: it is done already, as
    /// what is quick needs no second frame. `isBoardSame`: since the last request nothing but the picture in a plane
    /// has changed.
    [[nodiscard]] bool request(const render::Camera& camera, QSize pixels, bool isBoardSame);
    /// The same for `whole`, unless a picture is under way; what is asked for later comes after it.
    void requestWhole(const render::Camera& camera, QSize pixels);
    /// A picture was asked for and is not there.
    [[nodiscard]] bool isUnderWay() const { return m_wanted.has_value() || m_isDrawing; }
    [[nodiscard]] const Shot& shot() const { return m_shot; }
    /// A picture of all of the board, coarse, and as it looked some time ago: for what `shot` does not reach.
    [[nodiscard]] const Shot& whole() const { return m_whole; }
    /// The last picture shows all of the board.
    void keepAsWhole() { m_whole = m_shot; }
    /// Begins to make what the first picture needs, in the background.
    void makeReady();
    /// The picture is one of another board, and so will be what the device draws now.
    void clear();
    /// Gives up everything made from the device, and the picture.
    void release();

signals:
    /// There is another picture.
    void done();
    void deviceLost();

private:
    struct Wanted {
        render::Camera camera;
        QSize pixels;
        bool isBoardSame = false;
        bool isWhole = false;
    };
    /// What was made for pictures of this size since the last was drawn.
    struct Prepared {
        QSize pixels;
        int times = 0;
    };

    bool begin();
    [[nodiscard]] bool isPrepared();
    bool takeIfDone(std::uint64_t patienceNs);
    void keep();
    void stop();
    [[nodiscard]] render::ViewSettings settingsOf(const Wanted& wanted) const;

    GpuContext& m_context;
    const Picture& m_picture;
    std::optional<render::OffscreenPresenter> m_presenter;
    std::optional<Wanted> m_wanted;  ///< next
    Wanted m_drawn;                  ///< by the device now
    std::future<void> m_preparing;   ///< what a picture needs of the device
    Prepared m_prepared;
    bool m_isDrawing = false;
    bool m_isOfBefore = false;  ///< what the device draws is to be forgotten
    Shot m_shot;
    Shot m_whole;
    QTimer m_look;  ///< runs while a picture is prepared or the device draws: is that done?
};

}  // namespace ui
