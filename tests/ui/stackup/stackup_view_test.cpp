// The drawing of the stack: a click isolates a layer in both views, keys step through layers, both forms are exported.

#include "ui/stackup/stackup_view.h"

#include <QDialog>
#include <QDockWidget>
#include <QStatusBar>
#include <QtTest>

#include "tests/locations.h"
#include "tests/ui/window_fixture.h"
#include "ui/layers/layers_panel.h"
#include "ui/shell/message_bar.h"
#include "ui/stackup/stackup_panel.h"

using ui::ActionId;

class StackupViewTest : public QObject {
    Q_OBJECT

private slots:
    void init() {
        m_fixture = std::make_unique<WindowFixture>();
        window().findChild<QDockWidget*>("stack")->raise();
        QVERIFY(m_fixture->openAndWait(locations::kTestData + QStringLiteral("/odb/drills")));
    }
    void cleanup() { QCOMPARE(validationErrorsOnClosing(m_fixture), 0U); }

    void aClickOnALayerShowsItAloneInBothViews() {
        const QImage solid = m_fixture->picture();
        const QImage flat = flatPicture();
        const std::size_t row = rowOf("L1");
        clickAt(view().bandRect(row).center() - QPointF(view().bandRect(row).width() / 2 - 1.0, 0.0));
        const model::LayerId layer = window().document()->stackup.rows[row].layer;
        QCOMPARE(window().layers().soloLayer(), layer);
        QCOMPARE(window().layersPanel().currentLayer(), layer);
        QVERIFY(differingPixels(solid, m_fixture->picture()) > 1000);
        QVERIFY(differingPixels(flat, flatPicture()) > 50);
        clickAt(view().bandRect(row).center() - QPointF(view().bandRect(row).width() / 2 - 1.0, 0.0));
        QVERIFY(!window().layers().soloLayer().isValid());
        QCOMPARE(differingPixels(solid, m_fixture->picture()), 0);
        QCOMPARE(differingPixels(flat, flatPicture()), 0);
    }

    void aClickOnALabelOrAHoleCountsToo() {
        const double label = view().bandRect(0).top() + view().drawing().bands[rowOf("L3")].label;
        clickAt({view().width() * 0.5, label});
        QCOMPARE(window().layers().soloLayer(), window().document()->findLayer("L3"));
        const auto& bores = view().drawing().bores;
        const auto buried = std::ranges::find(bores, model::HoleSpan::Buried, &model::StackupBarrel::span);
        QVERIFY(buried != bores.end());
        clickAt(view().boreRect(static_cast<std::size_t>(buried - bores.begin())).center());
        QCOMPARE(window().layers().soloLayer(), window().document()->findLayer("BURIED"));
    }

    void arrowsStepThroughTheLayersAndStopAtTheEnds() {
        const QStringList expected{"L1", "D1", "L2", "D2", "L3", "D3", "L4", "L4"};
        QStringList seen;
        for (qsizetype i = 0; i < expected.size(); ++i) {
            QTest::keyClick(&view(), Qt::Key_Down);
            seen += QString::fromStdString(window().document()->layer(window().layers().soloLayer()).name);
        }
        QCOMPARE(seen, expected);
        QTest::keyClick(&view(), Qt::Key_Up);
        QCOMPARE(window().layers().soloLayer(), window().document()->findLayer("D3"));
    }

    void copperIsExaggeratedOrNot() {
        QVERIFY(window().actions()[ActionId::ExaggerateCopper].isChecked());
        const double exaggerated = view().bandRect(rowOf("L2")).height();
        window().actions()[ActionId::ExaggerateCopper].trigger();
        QVERIFY(view().bandRect(rowOf("L2")).height() < exaggerated / 3);
        QCOMPARE(view().drawing().copperTimes, 1.0);
    }

    void whatIsDrawnFillsTheDrawing() {
        const QImage picture = view().grab().toImage();
        const QColor copper = window().layers().effectiveStyles()[0].colour;
        const QRectF band = view().bandRect(rowOf("L1"));
        const QPointF inside((view().boreRect(0).right() + view().boreRect(1).left()) / 2, band.center().y());
        QCOMPARE(picture.pixelColor((inside * picture.devicePixelRatio()).toPoint()), copper);
    }

    void theStackIsExportedAsItIsDrawn() {
        const QString drawing = m_fixture->folder() + "/stack.svg";
        window().save(ui::ActionId::ExportStackup, drawing);
        QVERIFY(!window().messageBar().isVisible());
        QVERIFY(contentsOf(drawing).contains("copper scale x"));
        window().actions()[ActionId::ExaggerateCopper].trigger();
        window().save(ui::ActionId::ExportStackup, drawing);
        QVERIFY(contentsOf(drawing).contains(", to scale"));
        const QString table = m_fixture->folder() + "/stack.csv";
        window().save(ui::ActionId::ExportStackup, table);
        QVERIFY(contentsOf(table).contains("\r\n1,L1,SIGNAL,35000,assumed,"));
        window().save(ui::ActionId::ExportStackup, m_fixture->folder() + "/no/such/folder/stack.csv");
        QVERIFY(window().messageBar().isVisible());
    }

    void exportAsksForAFile() {
        window().actions()[ActionId::ExportStackup].trigger();
        auto* dialog = window().findChild<QDialog*>();
        QVERIFY(dialog != nullptr && dialog->isVisible());
        dialog->close();
    }

private:
    TestWindow& window() { return m_fixture->window(); }
    ui::StackupView& view() { return window().stackupPanel().view(); }

    std::size_t rowOf(const char* name) {
        const auto& rows = window().document()->stackup.rows;
        return static_cast<std::size_t>(std::ranges::find(rows, name, &model::StackupRow::name) - rows.begin());
    }

    QImage flatPicture() {
        const base::Result<QImage> picture = window().views().flat().grabPicture();
        return picture ? picture->convertToFormat(QImage::Format_RGB32) : QImage();
    }

    void clickAt(QPointF at) { QTest::mouseClick(&view(), Qt::LeftButton, {}, at.toPoint()); }

    static QByteArray contentsOf(const QString& path) {
        QFile file(path);
        return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
    }

    std::unique_ptr<WindowFixture> m_fixture;
};

QTEST_MAIN(StackupViewTest)
#include "stackup_view_test.moc"
