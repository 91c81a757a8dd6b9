// What is recorded and painted later is what would have been painted at once, to the last bit.
#include "ui/canvas/recorded_painting.h"

#include <QPainterPath>
#include <QPixmap>
#include <QtTest>
#include <thread>

using ui::RecordedPainting;

namespace {

using Paint = void (*)(QPainter& painter);

QImage translucentImage() {
    QImage image(40, 30, QImage::Format_ARGB32_Premultiplied);
    image.fill(QColor(200, 30, 90, 77));
    return image;
}

void paintShapes(QPainter& painter) {
    painter.setPen(QPen(QColor(10, 200, 30, 150), 2.5, Qt::DashLine));
    painter.setBrush(QColor(40, 50, 200, 90));
    painter.drawEllipse(QRectF(10.3, 12.7, 50.0, 31.0));
    painter.drawRect(QRectF(60.5, 20.5, 30.0, 40.0));
    painter.drawPolygon(QPolygonF({{100, 10}, {150, 20}, {120, 70}, {140, 5}}), Qt::WindingFill);
    painter.drawPolyline(QPolygonF({{100, 80}, {150, 90}, {120, 130}}));
    painter.drawLine(QPointF(3.3, 4.4), QPointF(150.0, 133.3));
    painter.drawPoint(QPointF(77.0, 77.0));
    painter.fillRect(QRect(20, 90, 30, 20), Qt::yellow);
}

void paintWords(QPainter& painter) {
    QFont font = painter.font();
    font.setPixelSize(11);
    font.setBold(true);
    painter.setFont(font);
    painter.drawText(QPointF(5.0, 20.5), QStringLiteral("U12.5 −3,5 µm Ω"));
    painter.translate(40.0, 100.0);
    painter.rotate(-90);
    painter.setPen(Qt::red);
    painter.drawText(QRectF(0, 0, 80, 40), Qt::AlignCenter, QStringLiteral("two\nlines 漢 →"));
    painter.drawText(QPointF(0.0, 0.0), QStringLiteral("12.50"));
}

void paintClipped(QPainter& painter) {
    painter.save();
    painter.setClipRect(QRect(20, 20, 60, 60));
    painter.fillRect(QRect(0, 0, 200, 200), QColor(0, 0, 0, 100));
    painter.save();
    QPainterPath path;
    path.addEllipse(QRectF(30, 30, 70, 70));
    painter.setClipPath(path, Qt::IntersectClip);
    painter.setOpacity(0.4);
    painter.fillRect(QRect(0, 0, 200, 200), Qt::green);
    painter.restore();
    painter.drawLine(0, 0, 100, 100);
    painter.restore();
    painter.drawLine(0, 100, 100, 0);
}

void paintImages(QPainter& painter) {
    const QImage image = translucentImage();
    painter.drawImage(QPointF(3.0, 5.0), image);
    painter.drawImage(QRectF(50.0, 5.0, 90.0, 40.0), image, QRectF(4.0, 3.0, 20.0, 20.0));
    painter.setRenderHint(QPainter::SmoothPixmapTransform);
    painter.setTransform(QTransform(1.0, 0.2, 0.001, -0.1, 0.9, 0.0005, 10.0, 70.0, 1.0), true);
    painter.drawImage(QPointF(), image);
    painter.drawPixmap(QPointF(60.0, 10.0), QPixmap::fromImage(image));
}

void paintBlended(QPainter& painter) {
    painter.fillRect(QRect(10, 10, 80, 80), QColor(80, 160, 240));
    painter.setCompositionMode(QPainter::CompositionMode_Multiply);
    painter.fillRect(QRect(40, 40, 80, 80), QColor(200, 100, 50));
    painter.setRenderHint(QPainter::Antialiasing, false);
    painter.drawLine(QPointF(0.5, 3.2), QPointF(140.0, 77.7));
}

}  // namespace

class RecordedPaintingTest : public QObject {
    Q_OBJECT

private slots:
    void isWhatWouldHaveBeenPainted_data() {
        QTest::addColumn<Paint>("paint");
        QTest::addColumn<double>("scale");
        for (const double scale : {1.0, 3.7}) {
            QTest::addRow("shapes, %g", scale) << Paint(paintShapes) << scale;
            QTest::addRow("words, %g", scale) << Paint(paintWords) << scale;
            QTest::addRow("clips, %g", scale) << Paint(paintClipped) << scale;
            QTest::addRow("images, %g", scale) << Paint(paintImages) << scale;
            QTest::addRow("blended, %g", scale) << Paint(paintBlended) << scale;
        }
    }
    void isWhatWouldHaveBeenPainted() {
        QFETCH(Paint, paint);
        QFETCH(double, scale);
        const QSize size = (QSizeF(160.0, 140.0) * scale).toSize();
        const auto scaled = [&](QPainter& painter) {
            painter.setRenderHint(QPainter::Antialiasing);
            painter.scale(scale, scale);
            paint(painter);
        };
        QImage expected(size, QImage::Format_RGBX8888);
        expected.fill(QColor(60, 70, 80));
        QImage later = expected;
        {
            QPainter painter(&expected);
            scaled(painter);
        }
        const RecordedPainting recorded = RecordedPainting::of(size, scaled);
        std::thread([&] { recorded.paintOn(later); }).join();
        QCOMPARE(later, expected);
    }
};

QTEST_MAIN(RecordedPaintingTest)
#include "recorded_painting_test.moc"
