// The drawing of the stackup: a click selects a row and the views follow, Alt+click isolates, Esc returns; zones,
// findings and exports.

#include "ui/stackup/stackup_view.h"

#include <QFileDialog>
#include <QLabel>
#include <QScrollBar>
#include <QStatusBar>
#include <QToolBar>
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
        window().showPanel("stackup");
        QVERIFY(m_fixture->openAndWait(QString::fromStdString(m_fixture->copyOfJob("drills").string())));
    }
    void cleanup() { QCOMPARE(validationErrorsOnClosing(m_fixture), 0U); }

    void aClickOnALayerSelectsItsRowAndMakesItCurrent() {
        const std::size_t row = rowOf("L2");
        clickAt(edgeOf(row));
        QCOMPARE(panel().table().currentIndex().row(), static_cast<int>(row));
        QCOMPARE(panel().table().selectedRows(), std::vector<int>{static_cast<int>(row)});
        QCOMPARE(window().workspace().currentLayer(), layerOf("L2"));
        QCOMPARE(window().layersPanel().currentLayer(), layerOf("L2"));
        QVERIFY(!window().layers().soloLayer().isValid());
    }

    void theRowFollowsTheCurrentLayer() {
        window().workspace().setCurrentLayer(layerOf("L3"));
        QCOMPARE(panel().table().currentIndex().row(), static_cast<int>(rowOf("L3")));
        window().workspace().setCurrentLayer(layerOf("BURIED"));  // in no row
        QCOMPARE(panel().table().currentIndex().row(), static_cast<int>(rowOf("L3")));
        QCOMPARE(window().workspace().currentLayer(), layerOf("BURIED"));
    }

    void noRowOfTheBoardBeforeStaysSelected() {
        clickAt(edgeOf(rowOf("L2")));
        const QImage selected = view().grab().toImage();
        const std::filesystem::path job = m_fixture->copyOfJob("drills");
        const std::filesystem::path another = job.parent_path() / "another";  // with as many rows
        std::filesystem::copy(job, another, std::filesystem::copy_options::recursive);
        QVERIFY(m_fixture->openAndWait(QString::fromStdString(another.string())));
        QVERIFY(panel().table().selectedRows().empty());
        QVERIFY(!panel().table().currentIndex().isValid());
        const QImage opened = view().grab().toImage();
        QVERIFY(differingPixels(selected, opened) > 50);
        m_fixture->restart();
        window().showPanel("stackup");
        QVERIFY(m_fixture->openAndWait(QString::fromStdString(another.string())));
        QCOMPARE(view().grab().toImage(), opened);
    }

    void anotherBoardBeginsAtTheTop() {
        panel().table().setMaximumHeight(90);  // less than its rows need
        const QScrollBar& bar = *panel().table().verticalScrollBar();
        QTRY_VERIFY(bar.maximum() > 1);
        panel().table().scrollToBottom();
        const int bottom = bar.value();
        QVERIFY(bottom > 0);
        m_fixture->key(Qt::Key_F5);
        QTRY_VERIFY(!window().loader().isLoading());
        QCOMPARE(bar.value(), bottom);
        const std::filesystem::path another = m_fixture->copyOfJob("everything");  // with more rows
        QVERIFY(m_fixture->openAndWait(QString::fromStdString(another.string())));
        QVERIFY(bar.maximum() > 1);
        QCOMPARE(bar.value(), 0);
    }

    void altClickShowsALayerAloneInBothViewsAndEscEndsIt() {
        const QImage solid = m_fixture->picture();
        const QImage flat = flatPicture();
        clickAt(edgeOf(rowOf("L3")), Qt::AltModifier);
        QCOMPARE(window().layers().soloLayer(), layerOf("L3"));
        QCOMPARE(window().layersPanel().currentLayer(), layerOf("L3"));
        QVERIFY(differingPixels(solid, m_fixture->picture()) > 1000);
        QVERIFY(differingPixels(flat, flatPicture()) > 50);
        m_fixture->key(Qt::Key_Escape);
        QVERIFY(!window().layers().soloLayer().isValid());
        window().workspace().setCurrentLayer({});  // it was the one that 2D draws over the others
        QCOMPARE(differingPixels(solid, m_fixture->picture()), 0);
        QCOMPARE(differingPixels(flat, flatPicture()), 0);
    }

    void altClickAgainEndsItToo() {
        for (const char* alone : {"L1", "L3", "", "L3"}) {
            clickAt(edgeOf(rowOf(*alone != 0 ? alone : "L3")), Qt::AltModifier);
            QCOMPARE(window().layers().soloLayer(), *alone != 0 ? layerOf(alone) : model::LayerId{});
        }
    }

    void whatDrawsNothingIsNotShownAlone() {
        clickAt(edgeOf(rowOf("D2")), Qt::AltModifier);
        QVERIFY(!window().layers().soloLayer().isValid());
        QCOMPARE(panel().table().currentIndex().row(), static_cast<int>(rowOf("D2")));
        QVERIFY(window().statusBar()->currentMessage().contains("D2 draws nothing"));
    }

    void whileALayerIsAloneTheNextOneTakesItsTurn() {
        clickAt(edgeOf(rowOf("L1")), Qt::AltModifier);
        clickAt(edgeOf(rowOf("L4")));
        QCOMPARE(window().layers().soloLayer(), layerOf("L4"));
        clickAt(edgeOf(rowOf("D1")));  // draws nothing: both views would be empty
        QCOMPARE(window().layers().soloLayer(), layerOf("L4"));
    }

    void aCaptionWithoutRoomForTheNameSaysWhatTheHolesAre() {
        const std::size_t bore = 0;
        const QString whole = view().captionOf(bore, 10'000);
        const auto& layer = view().drawing().bores[bore].layer;
        const QString name = QString::fromStdString(window().document()->layer(layer).name);
        QVERIFY2(whole.startsWith("1  " + name + ": "), qPrintable(whole));
        const QString unnamed = QString(whole).remove(name + ": ");
        const int room = view().fontMetrics().horizontalAdvance(unnamed) + 4;
        QCOMPARE(view().captionOf(bore, room), unnamed);
        QVERIFY(view().captionOf(bore, room / 2).startsWith(unnamed.left(8)));
        // The line of the caption says the whole of it.
        const QString tip = view().tipAt({view().width() * 0.5, view().captionRect(bore).center().y()});
        QCOMPARE("1  " + tip, whole);
    }

    void aClickOnALabelOrAHoleCountsToo() {
        const double label = view().bandRect(0).top() + view().drawing().bands[rowOf("L3")].label;
        clickAt({view().width() * 0.5, label});
        QCOMPARE(panel().table().currentIndex().row(), static_cast<int>(rowOf("L3")));
        const auto& bores = view().drawing().bores;
        const auto buried = std::ranges::find(bores, model::HoleSpan::Buried, &model::StackupBarrel::span);
        QVERIFY(buried != bores.end());
        const QPointF hole = view().boreRect(static_cast<std::size_t>(buried - bores.begin())).center();
        clickAt(hole);
        QCOMPARE(window().workspace().currentLayer(), layerOf("BURIED"));
        clickAt(hole, Qt::AltModifier);
        QCOMPARE(window().layers().soloLayer(), layerOf("BURIED"));
    }

    void arrowsStepThroughTheRowsAndStopAtTheEnds() {
        const QStringList expected{"L1", "D1", "L2", "D2", "L3", "D3", "L4", "L4"};
        QStringList seen;
        for (qsizetype i = 0; i < expected.size(); ++i) {
            QTest::keyClick(&view(), Qt::Key_Down);
            seen += panel().table().currentIndex().siblingAtColumn(ui::StackupModel::Name).data().toString();
        }
        QCOMPARE(seen, expected);
        QTest::keyClick(&view(), Qt::Key_Up);
        QCOMPARE(window().workspace().currentLayer(), layerOf("D3"));
    }

    void zonesAreDrawnSideBySide() {
        QVERIFY(m_fixture->openAndWait(locations::kTestData + QStringLiteral("/odb/rigid_flex")));
        const std::size_t top = rowOf("TOP");
        const QImage picture = view().grab().toImage();
        const auto colourAt = [&](std::size_t zone) {
            return picture.pixelColor((view().zoneRect(top, zone).center() * picture.devicePixelRatio()).toPoint());
        };
        QCOMPARE(view().drawing().columns.size(), std::size_t{3});
        QVERIFY(colourAt(0) != colourAt(1));
        QCOMPARE(colourAt(1), colourAt(2));  // neither has it
        clickAt(view().zoneRect(top, 0).center());
        QCOMPARE(panel().table().currentIndex().row(), static_cast<int>(top));
    }

    void zonesWithoutRoomForTheirNamesHaveLetters() {
        QVERIFY(m_fixture->openAndWait(locations::kTestData + QStringLiteral("/odb/rigid_flex")));
        ui::StackupView wide;
        wide.resize(1600, 700);
        wide.setStackup(window().workspace().board()->document);
        QCOMPARE(wide.letteredZones(), std::size_t{0});
        ui::StackupView narrow;
        narrow.resize(160, 700);
        narrow.setStackup(window().workspace().board()->document);
        QCOMPARE(narrow.letteredZones(), std::size_t{3});
        const QString flex = QString::fromStdString(narrow.drawing().columns[1].part.name);
        QCOMPARE(narrow.zoneCaptionOf(1, 1'000), "B  " + flex);
        QCOMPARE(narrow.tipAt(narrow.zoneHeading(1).center()), flex);
        QVERIFY2(narrow.minimumHeight() > wide.minimumHeight(), "a line below the drawing for each");
    }

    /// As in a column beside the views.
    void aNarrowPanelHasRoomForNamesAndCommands() {
        ui::StackupView narrow;
        narrow.resize(200, 700);
        narrow.setStackup(window().workspace().board()->document);
        QVERIFY(narrow.nameRoom() >= narrow.fontMetrics().averageCharWidth() * 8);
        QVERIFY2(narrow.bandRect(0).width() > 24, "the layers are still seen");
        ui::StackupModel model;
        ui::StackupPanel column(model, window().actions());
        column.resize(200, 700);
        column.show();
        model.setDocument(window().workspace().board()->document);
        auto* commands = column.findChild<QToolBar*>();
        QVERIFY(!column.findChild<QLabel*>("stackupTotal")->text().isEmpty());
        const QWidget* exaggerate = commands->widgetForAction(&window().actions()[ActionId::ExaggerateCopper]);
        QTRY_VERIFY(exaggerate->isVisible() && exaggerate->width() >= exaggerate->sizeHint().width());
        QVERIFY2(column.findChild<QLabel*>("stackupTotal")->height() < 2 * column.fontMetrics().height(),
                 "the drawing has the height");
    }

    void findingsAreListedAndSelectTheirRows() {
        QVERIFY(panel().findings().isHidden());
        QVERIFY(
            window().stack().setData(window().stack().index(static_cast<int>(rowOf("L2")), ui::StackupModel::Thickness),
                                     "490 um", Qt::EditRole));
        QVERIFY(!panel().findings().isHidden());
        QVERIFY(panel().findings().model()->index(0, 0).data().toString().startsWith("Copper L2 490 µm"));
        const QRect line = panel().findings().visualRect(panel().findings().model()->index(0, 0));
        QTest::mouseClick(panel().findings().viewport(), Qt::LeftButton, {}, line.center());
        QCOMPARE(panel().table().selectedRows(), std::vector<int>{static_cast<int>(rowOf("L2"))});
        window().actions()[ActionId::Undo].trigger();
        QVERIFY(panel().findings().isHidden());
    }

    /// Of EasyEDA's files: whatever is left of a name tells it from the others.
    void namesThatDoNotFitAreCutWhereTheyAreAlike() {
        const QStringList names{"Gerber_TopSilkLayer", "Gerber_TopPasteMaskLayer", "Gerber_TopSolderMaskLayer",
                                "Gerber_TopLayer",     "Gerber_BottomLayer",       "Gerber_BottomSolderMaskLayer"};
        const QFontMetrics metrics = view().fontMetrics();
        const int width = metrics.horizontalAdvance("Gerber_TopLay");
        const ui::NameCut cut = ui::NameCut::forAll(names, metrics, width);
        QSet<QString> shown;
        for (const QString& name : names) {
            shown.insert(cut.of(name, metrics, width));
            QVERIFY(metrics.horizontalAdvance(cut.of(name, metrics, width)) <= width);
        }
        QVERIFY2(shown.size() == names.size(), qPrintable(QStringList(shown.values()).join(' ')));
        const ui::NameCut plain = ui::NameCut::forAll({"TOP", "BOTTOM"}, metrics, width);
        QCOMPARE(plain.of("TOP", metrics, width), "TOP");
    }

    void theTotalIsSeenWithoutScrolling() {
        QLabel* total = window().findChild<QLabel*>("stackupTotal");
        QCOMPARE(total->text(), "Cu to Cu 1.6 mm");
        QVERIFY2(total->width() >= total->sizeHint().width(), "all of it");
        QVERIFY(total->toolTip().startsWith("Copper to copper 1.6 mm, overall "));
        QVERIFY(m_fixture->openAndWait(locations::kTestData + QStringLiteral("/odb/rigid_flex")));
        QCOMPARE(window().label("stackupTotal"), "3 zones");
        QVERIFY(total->toolTip().contains("Flex: copper to copper 556.67 µm"));
    }

    void drawingTotalsFindingsAndExportsAreInTheUnitOfTheWindow() {
        const QPointF layer(view().bandRect(rowOf("L1")).left() + 1.0, view().bandRect(rowOf("L1")).center().y());
        const QPointF hole = view().boreRect(0).center();
        const QImage before = view().grab().toImage();
        QVERIFY(view().tipAt(layer).startsWith("L1: 35 µm"));
        while (window().workspace().unit() != ui::LengthUnit::Mil) {
            m_fixture->key(Qt::Key_Q);
        }
        QVERIFY(differingPixels(before, view().grab().toImage()) > 50);
        QVERIFY2(view().tipAt(layer).startsWith("L1: 1.38 mil"), qPrintable(view().tipAt(layer)));
        QVERIFY2(view().tipAt(hole).endsWith(" mil"), qPrintable(view().tipAt(hole)));
        QCOMPARE(window().label("stackupTotal"), "Cu to Cu 62.99 mil");
        const QModelIndex thickness =
            window().stack().index(static_cast<int>(rowOf("L2")), ui::StackupModel::Thickness);
        QVERIFY(window().stack().setData(thickness, "490 um", Qt::EditRole));
        QVERIFY(
            panel().findings().model()->index(0, 0).data().toString().startsWith("Copper L2 19.29 mil: foils are "
                                                                                 "0.2 mil to 18.9 mil thick"));
        const QString drawing = m_fixture->folder() + "/mil.svg";
        window().save(ui::ActionId::ExportStackup, drawing);
        QVERIFY(contentsOf(drawing).contains(">1.38 mil<") && contentsOf(drawing).contains("overall "));
        QVERIFY(!contentsOf(drawing).contains("µm") && !contentsOf(drawing).contains(" mm"));
        m_fixture->key(Qt::Key_Q);
        QVERIFY(window().label("stackupTotal").endsWith(" in"));
        m_fixture->key(Qt::Key_Q);
        QCOMPARE(window().label("stackupTotal").left(9), "Cu to Cu ");
        QVERIFY(panel().findings().model()->index(0, 0).data().toString().startsWith("Copper L2 490 µm"));
        window().actions()[ActionId::Undo].trigger();
    }

    void aPdfIsOnePage() {
        const QString path = m_fixture->folder() + "/stackup.pdf";
        window().save(ui::ActionId::ExportStackup, path);
        QVERIFY(!window().messageBar().isVisible());
        const QByteArray bytes = contentsOf(path);
        QVERIFY(bytes.startsWith("%PDF-") && bytes.contains("/Count 1"));
        QVERIFY(bytes.size() > 3000);
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

    /// As those of the paper do.
    void aBoardThatStatesItsHeightsHasNoStackupToExport() {
        const QString path = m_fixture->folder() + "/heights.txt";
        QFile file(path);
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write(
            "LAYERBEGIN\nLAYERTYPE,Top\nBASEPLANEHEIGHT,8.0\nTHICKNESS,1.2\nLINEBEGIN\nLINEID,1\nLINEDATA,2\n"
            "0.0,0.0\nSTRAIGHT,1,20.0,100.0,0.0\nLINEEND\nLAYEREND\n");
        file.close();
        QVERIFY(m_fixture->openAndWait(path));
        QVERIFY(window().document()->stackup.rows.empty());
        window().actions()[ActionId::ExportStackup].trigger();
        QVERIFY(window().findChild<QFileDialog*>() == nullptr);
        const QString said = window().statusBar()->currentMessage();
        QVERIFY2(said.startsWith("There is no stackup to export"), qPrintable(said));
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

    ui::StackupPanel& panel() { return window().stackupPanel(); }
    model::LayerId layerOf(const char* name) { return window().document()->findLayer(name); }
    /// Of a band, where no hole is drawn.
    QPointF edgeOf(std::size_t row) {
        const QRectF band = view().bandRect(row);
        return {band.left() + 1.0, band.center().y()};
    }

    void clickAt(QPointF at, Qt::KeyboardModifiers modifiers = {}) {
        QTest::mouseClick(&view(), Qt::LeftButton, modifiers, at.toPoint());
    }

    static QByteArray contentsOf(const QString& path) {
        QFile file(path);
        return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
    }

    std::unique_ptr<WindowFixture> m_fixture;
};

QTEST_MAIN(StackupViewTest)
#include "stackup_view_test.moc"
