#pragma once

#include <QPaintDevice>
#include <QPainter>
#include <QSize>
#include <functional>
#include <memory>
#include <vector>

namespace ui {

/// What was painted, call by call, to be painted on a picture by any thread: painters read what belongs to the thread
/// of the window, and a large picture takes them longer than it may wait. QPicture would pack images as files, which
/// takes long and rounds their colours, and lays words out elsewhere.
class RecordedPainting {
public:
    /// What `paint(QPainter&)` paints on a picture of this size, in pixels.
    template <class Paint>
    static RecordedPainting of(QSize pixels, const Paint& paint) {
        RecordedPainting painting;
        Recorder recorder(pixels, painting.m_calls);
        QPainter painter(&recorder);
        paint(painter);
        return painting;
    }

    /// The picture is what it would be had it been painted at once.
    void paintOn(QImage& picture) const;

private:
    using Calls = std::vector<std::function<void(QPainter&)>>;
    class Engine;

    class Recorder : public QPaintDevice {
    public:
        Recorder(QSize pixels, Calls& calls);
        ~Recorder() override;
        [[nodiscard]] QPaintEngine* paintEngine() const override;

    protected:
        [[nodiscard]] int metric(PaintDeviceMetric metric) const override;

    private:
        QSize m_pixels;
        std::unique_ptr<Engine> m_engine;
    };

    Calls m_calls;
};

}  // namespace ui
