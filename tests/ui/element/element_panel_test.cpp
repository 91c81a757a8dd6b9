#include "ui/element/element_panel.h"

#include <QClipboard>
#include <QFile>
#include <QtTest>

#include "tests/locations.h"
#include "tests/ui/window_fixture.h"
#include "ui/common/display_units.h"
#include "ui/theme/theme.h"

class ElementPanelTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() {
        m_fixture = std::make_unique<WindowFixture>();
        QVERIFY(m_fixture->openAndWait(locations::kSample));
    }
    void cleanupTestCase() {
        ui::applyTheme(ui::Theme::System);
        QCOMPARE(validationErrorsOnClosing(m_fixture), 0U);
    }

    /// What was listed before the theme is chosen, too.
    void linksHaveTheColourOfTheTheme() {
        window().elementPanel().show();
        window().selection().select({{0, model::ElementId{0}}});
        for (const ui::Theme theme : {ui::Theme::Dark, ui::Theme::Light, ui::Theme::Dark}) {
            ui::applyTheme(theme);
            QTRY_COMPARE(linkColour(), QGuiApplication::palette().color(QPalette::Link));
        }
    }

    void factsAreCopiedAsAnyRows() {
        window().selection().select({{0, model::ElementId{0}}});
        ui::TableView& facts = table();
        QVERIFY(facts.model()->rowCount() > 2);
        facts.selectAll();
        QTest::keyClick(&facts, Qt::Key_C, Qt::ControlModifier);
        const QString copied = QGuiApplication::clipboard()->text();
        QCOMPARE(copied.count('\n'), facts.model()->rowCount());
        QVERIFY2(copied.contains("Layer\t" + window().fact("Layer") + '\n'), qPrintable(copied));
        facts.copyAll();
        QCOMPARE(QGuiApplication::clipboard()->text(), "Property\tValue\n" + copied);
    }

    /// Where its symbol is placed, whatever its shape.
    void aPadHasAPosition() {
        const model::Document& board = *window().document();
        std::size_t row = 0;
        const auto isPadWithSymbol = [&](std::size_t at) {
            return board.elements.kind[at] == model::ElementKind::Area && board.elements.symbol[at].isValid() &&
                   (board.elements.flags[at] & model::kPad) != 0;
        };
        while (!isPadWithSymbol(row)) {
            ++row;
        }
        const model::Placement& placed = board.areas[board.elements.geometry[row]].placement;
        window().selection().select({{0, model::ElementId{row}}});
        QCOMPARE(window().fact("Position"),
                 ui::positionText(placed.origin.x, placed.origin.y, window().workspace().unit()));
        QVERIFY(window().fact("Rotation").endsWith("clockwise"));
        QVERIFY(window().fact("Islands").isEmpty());
    }

    void aPadSaysItsHoleAndItsAnnularRing() {
        QVERIFY(m_fixture->openAndWait(
            boardWith("hole",
                      "(attr through_hole) (pad \"1\" thru_hole circle (at 0 0) (size 2 2) (drill 1) "
                      "(layers \"*.Cu\") (net 1 \"A\")) (pad \"2\" smd circle (at 5 0) (size 2 2) "
                      "(layers \"F.Cu\") (net 1 \"A\"))")));
        const model::Document& board = *window().document();
        const auto isWanted = [&](std::size_t row, int flag, base::Nm atX) {
            const model::Box box = board.boxOf(model::ElementId{row});
            return (board.elements.flags[row] & flag) != 0 && box.min.x < atX && atX < box.max.x;
        };
        const auto first = [&](int flag, base::Nm atX) {
            std::size_t row = 0;
            while (!isWanted(row, flag, atX)) {
                ++row;
            }
            return model::ElementId{row};
        };
        const auto drilled = static_cast<double>(board.boxOf(first(model::kHole, 6'000'000)).width());
        const auto text = [this](double nm) { return ui::lengthInBoth(nm, window().workspace().unit()); };
        window().selection().select({{0, first(model::kPad, 6'000'000)}});
        QCOMPARE(window().fact("Hole"), text(drilled));
        QCOMPARE(window().fact("Annular ring"), text((2e6 - drilled) / 2));
        window().selection().select({{0, first(model::kPad, 11'000'000)}});
        QVERIFY(window().fact("Hole").isEmpty() && window().fact("Annular ring").isEmpty());
        QVERIFY(m_fixture->openAndWait(locations::kSample));
    }

    /// In a panel that is as narrow as the window makes it at first.
    void longNamesOfAttributesLeaveRoomForValues() {
        QVERIFY(m_fixture->openAndWait(boardWithALongAttribute()));
        m_fixture->key(Qt::Key_F, Qt::ControlModifier);
        QTest::keyClicks(&window().searchBox().line(), "R1");
        QTest::keyClick(&window().searchBox().line(), Qt::Key_Return);
        QTRY_VERIFY(!window().fact("Position").isEmpty());
        const ui::TableView& table = this->table();
        const QAbstractItemView& cells = table;
        QVERIFY(cells.sizeHintForColumn(0) + cells.sizeHintForColumn(1) > table.viewport()->width());
        QTRY_VERIFY(table.columnWidth(1) >= std::min(cells.sizeHintForColumn(1), table.viewport()->width() / 2));
        for (int row = 0; row < table.model()->rowCount(); ++row) {
            const QModelIndex name = table.model()->index(row, 0);
            QCOMPARE(name.data(Qt::ToolTipRole), name.data());
        }
        QVERIFY(m_fixture->openAndWait(locations::kSample));
    }

private:
    QString boardWithALongAttribute() {
        return boardWith("attribute",
                         "(property \"Number of the part in the catalogue of the manufacturer\" \"12\") (attr smd) "
                         "(pad \"1\" smd rect (at 0 0) (size 3 3) (layers \"F.Cu\") (net 1 \"A\"))");
    }
    /// With a component R1 at 6, 10 mm, of which this is said.
    QString boardWith(const char* name, const QByteArray& component) {
        const QString path = m_fixture->folder() + '/' + name + ".kicad_pcb";
        QFile file(path);
        if (file.open(QFile::WriteOnly)) {
            file.write(
                "(kicad_pcb (version 20241229) (generator \"pcbnew\") (layers (0 \"F.Cu\" signal) (2 \"B.Cu\" signal) "
                "(25 \"Edge.Cuts\" user)) (net 0 \"\") (net 1 \"A\") "
                "(footprint \"R\" (layer \"F.Cu\") (at 6 10) (property \"Reference\" \"R1\") " +
                component +
                ") (gr_rect (start 0 0) (end 20 20) (stroke (width 0.1) (type default)) (fill no) (layer "
                "\"Edge.Cuts\")))");
        }
        return path;
    }
    TestWindow& window() { return m_fixture->window(); }
    ui::TableView& table() { return *window().elementPanel().findChild<ui::TableView*>(); }

    QColor linkColour() {
        const QAbstractItemModel& facts = *table().model();
        for (int row = 0; row < facts.rowCount(); ++row) {
            if (facts.index(row, 0).data().toString() == QLatin1String("Layer")) {
                return facts.index(row, 1).data(Qt::ForegroundRole).value<QColor>();
            }
        }
        return {};
    }

    std::unique_ptr<WindowFixture> m_fixture;
};

QTEST_MAIN(ElementPanelTest)
#include "element_panel_test.moc"
