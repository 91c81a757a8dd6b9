#include "ui/canvas/recorded_painting.h"

#include <QFontMetricsF>
#include <QImage>
#include <QPaintEngine>
#include <QPainterPath>
#include <QPixmap>
#include <cmath>
#include <span>
#include <utility>

namespace ui {

namespace {

/// Metrics of a picture of one pixel, which are those of all.
int metricOfPictures(QPaintDevice::PaintDeviceMetric metric) {
    const QImage picture(1, 1, QImage::Format_RGBX8888);
    switch (metric) {
        case QPaintDevice::PdmDpiX: return picture.logicalDpiX();
        case QPaintDevice::PdmDpiY: return picture.logicalDpiY();
        case QPaintDevice::PdmPhysicalDpiX: return picture.physicalDpiX();
        case QPaintDevice::PdmPhysicalDpiY: return picture.physicalDpiY();
        case QPaintDevice::PdmDepth: return picture.depth();
        default: return 0;
    }
}

template <class Value>
std::vector<Value> copyOf(const Value* values, int count) {
    return {values, values + count};
}

}  // namespace

/// Keeps what QPainter hands on to whoever paints.
class RecordedPainting::Engine : public QPaintEngine {
public:
    explicit Engine(Calls& calls) : QPaintEngine(QPaintEngine::AllFeatures), m_calls(calls) {}

    bool begin(QPaintDevice*) override { return true; }
    bool end() override { return true; }
    [[nodiscard]] Type type() const override { return QPaintEngine::User; }

    void updateState(const QPaintEngineState& now) override {
        const DirtyFlags changed = now.state();
        keepStrokes(now, changed);
        keepBlending(now, changed);
        if (changed.testFlag(DirtyTransform)) {
            keep([transform = now.transform()](QPainter& painter) { painter.setTransform(transform); });
        }
        keepClip(now, changed);
    }
    void drawPath(const QPainterPath& path) override {
        keep([path](QPainter& painter) { painter.drawPath(path); });
    }
    void drawLines(const QLineF* lines, int count) override {
        keep([all = copyOf(lines, count)](QPainter& painter) {
            painter.drawLines(all.data(), static_cast<int>(all.size()));
        });
    }
    void drawRects(const QRectF* rects, int count) override {
        keep([all = copyOf(rects, count)](QPainter& painter) {
            painter.drawRects(all.data(), static_cast<int>(all.size()));
        });
    }
    void drawPoints(const QPointF* points, int count) override {
        keep([all = copyOf(points, count)](QPainter& painter) {
            painter.drawPoints(all.data(), static_cast<int>(all.size()));
        });
    }
    void drawEllipse(const QRectF& rect) override {
        keep([rect](QPainter& painter) { painter.drawEllipse(rect); });
    }
    void drawPolygon(const QPointF* points, int count, PolygonDrawMode mode) override {
        keep([all = copyOf(points, count), mode](QPainter& painter) {
            const auto size = static_cast<int>(all.size());
            if (mode == PolylineMode) {
                painter.drawPolyline(all.data(), size);
            } else {
                painter.drawPolygon(all.data(), size, mode == WindingMode ? Qt::WindingFill : Qt::OddEvenFill);
            }
        });
    }
    void drawPixmap(const QRectF& to, const QPixmap& pixmap, const QRectF& from) override {
        drawImage(to, pixmap.toImage(), from, Qt::AutoColor);
    }
    void drawImage(const QRectF& to, const QImage& image, const QRectF& from, Qt::ImageConversionFlags flags) override {
        keep([to, image, from, flags](QPainter& painter) { painter.drawImage(to, image, from, flags); });
    }
    void drawTextItem(const QPointF& at, const QTextItem& item) override {
        if (std::abs(QFontMetricsF(item.font(), painter()->device()).horizontalAdvance(item.text()) - item.width()) >
            kSameWidth) {
            QPaintEngine::drawTextItem(at, item);  // the part of the words that one of several fonts has, as outlines
            return;
        }
        keep([at, text = item.text(), font = item.font()](QPainter& painter) {
            painter.setFont(font);
            painter.drawText(at, text);
        });
    }

private:
    static constexpr double kSameWidth = 0.5;

    template <class Call>
    void keep(Call call) {
        m_calls.emplace_back(std::move(call));
    }
    void keepStrokes(const QPaintEngineState& now, DirtyFlags changed) {
        if (changed.testFlag(DirtyPen)) {
            keep([pen = now.pen()](QPainter& painter) { painter.setPen(pen); });
        }
        if (changed.testFlag(DirtyBrush)) {
            keep([brush = now.brush()](QPainter& painter) { painter.setBrush(brush); });
        }
        if (changed.testFlag(DirtyBrushOrigin)) {
            keep([origin = now.brushOrigin()](QPainter& painter) { painter.setBrushOrigin(origin); });
        }
    }
    void keepBlending(const QPaintEngineState& now, DirtyFlags changed) {
        if (changed.testFlag(DirtyHints)) {
            keep([hints = now.renderHints()](QPainter& painter) {
                painter.setRenderHints(painter.renderHints(), false);
                painter.setRenderHints(hints);
            });
        }
        if (changed.testFlag(DirtyOpacity)) {
            keep([opacity = now.opacity()](QPainter& painter) { painter.setOpacity(opacity); });
        }
        if (changed.testFlag(DirtyCompositionMode)) {
            keep([mode = now.compositionMode()](QPainter& painter) { painter.setCompositionMode(mode); });
        }
    }
    void keepClip(const QPaintEngineState& now, DirtyFlags changed) {
        const Qt::ClipOperation operation = now.clipOperation();
        const bool isOfClip = changed.testFlag(DirtyClipPath) || changed.testFlag(DirtyClipRegion);
        if (isOfClip && operation == Qt::NoClip) {
            keep([](QPainter& painter) { painter.setClipping(false); });
            return;
        }
        if (changed.testFlag(DirtyClipPath)) {
            keep([path = now.clipPath(), operation](QPainter& painter) { painter.setClipPath(path, operation); });
        }
        if (changed.testFlag(DirtyClipRegion)) {
            keep([region = now.clipRegion(), operation](QPainter& painter) {
                painter.setClipRegion(region, operation);
            });
        }
        if (changed.testFlag(DirtyClipEnabled)) {
            keep([isOn = now.isClipEnabled()](QPainter& painter) { painter.setClipping(isOn); });
        }
    }

    Calls& m_calls;
};

RecordedPainting::Recorder::Recorder(QSize pixels, Calls& calls)
    : m_pixels(pixels), m_engine(std::make_unique<Engine>(calls)) {}

RecordedPainting::Recorder::~Recorder() = default;

QPaintEngine* RecordedPainting::Recorder::paintEngine() const {
    return m_engine.get();
}

int RecordedPainting::Recorder::metric(PaintDeviceMetric metric) const {
    switch (metric) {
        case PdmWidth: return m_pixels.width();
        case PdmHeight: return m_pixels.height();
        case PdmDevicePixelRatio: return 1;
        case PdmDevicePixelRatioScaled: return static_cast<int>(devicePixelRatioFScale());
        default: return metricOfPictures(metric);
    }
}

void RecordedPainting::paintOn(QImage& picture) const {
    QPainter painter(&picture);
    for (const auto& call : m_calls) {
        call(painter);
    }
}

}  // namespace ui
