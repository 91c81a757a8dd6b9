// The Nets panel in the window: groups, what is known of nets, and nets of steps that a panel places.

#include <QComboBox>
#include <QtTest>

#include "tests/places.h"
#include "tests/ui/window_fixture.h"
#include "ui/nets_panel.h"
#include "ui/table_view.h"

using model::BoardNet;
using ui::models::NetModel;

class NetsTest : public QObject {
    Q_OBJECT

private slots:
    void init() { m_fixture = std::make_unique<WindowFixture>(); }
    void cleanup() {
        const std::uint32_t errors = m_fixture->context().validationErrors();
        m_fixture.reset();
        QCOMPARE(errors, 0U);
    }

    void aHeadingStandsForItsNets() {
        open(places::kSample);
        panel().groupBox().setCurrentText("By supply");
        QTRY_VERIFY(nets().isArranged() && nets().isHeading(0));
        const int end = nets().endOfGroup(0);
        QVERIFY(end > 1);
        click(0);
        QCOMPARE(window().selection().nets().size(), static_cast<std::size_t>(end - 1));
        QCOMPARE(table().selectionModel()->selectedRows().size(), end);
        click(0, Qt::ControlModifier);
        QVERIFY2(window().selection().nets().empty(), "taken back alone, a heading takes its nets with it");
        click(0);
        click(1);
        QCOMPARE(window().selection().nets(), (std::vector<BoardNet>{{0, nets().netAt(1)}}));
        m_fixture->key(Qt::Key_Escape);
        QVERIFY(table().selectionModel()->selectedRows().isEmpty());
    }

    void whatIsKnownOfTheHighlightedNetsStandsBelow() {
        open(places::kSample);
        QVERIFY(panel().details().isEmpty());
        const model::NetId gnd = window().document()->findNet("GND");
        window().selection().setNets({{0, gnd}});
        QVERIFY(panel().details().startsWith("GND\n"));
        QVERIFY(panel().details().contains("via"));
        double routed = 0.0;
        const auto lengths = model::routedLengths(*window().document(), gnd);
        for (const auto& [layer, length] : lengths) {
            QVERIFY(panel().details().contains(QString::fromStdString(window().document()->layer(layer).name) + ": "));
            routed += length;
        }
        QVERIFY(routed > 0.0);
        window().selection().setNets({});
        QVERIFY(panel().details().isEmpty());
    }

    void netsOfPlacedStepsAreListedAndFollowed() {
        open(QString(places::kTestData) + "/odb/panel");
        const model::StepTree& tree = window().selection().tree();
        QVERIFY(tree.steps.size() > 1 && !panel().stepBox().isHidden());
        QStringList steps;
        for (int i = 0; i < panel().stepBox().count(); ++i) {
            steps += panel().stepBox().itemText(i);
        }
        QVERIFY(steps.contains("CARD") && steps.contains("COUPON"));
        // The net of an element in a late copy of each step: the table goes there and N lights it up.
        for (std::uint32_t copy = static_cast<std::uint32_t>(tree.copies.size()); copy-- > 1;) {
            const std::uint32_t step = tree.copies[copy].step;
            if (tree.steps[step]->nets.empty() || tree.steps[step]->netElements.empty()) {
                continue;
            }
            const model::BoardElement at{copy, tree.steps[step]->netElements.front()};
            window().selection().select({at});
            QTRY_VERIFY(nets().isArranged());
            QCOMPARE(panel().stepBox().currentData().toUInt(), step);
            const BoardNet net = *window().selection().netOf(at);
            QTRY_COMPARE(table().currentIndex().row(), *nets().rowOf(net.net));
            m_fixture->key(Qt::Key_N);
            QCOMPARE(window().selection().nets(), std::vector{net});
            QVERIFY(!window().selection().highlight()[step].empty());
            QVERIFY(!panel().details().isEmpty());
            m_fixture->key(Qt::Key_N);
        }
    }

private:
    ui::MainWindow& window() { return m_fixture->window(); }
    ui::NetsPanel& panel() { return window().netsPanel(); }
    NetModel& nets() { return window().nets(); }
    ui::TableView& table() { return panel().table(); }
    void open(const QString& path) {
        QVERIFY(m_fixture->openAndWait(path));
        QTRY_VERIFY(nets().isArranged());
    }
    void click(int row, Qt::KeyboardModifiers modifiers = Qt::NoModifier) {
        table().scrollTo(nets().index(row, NetModel::Name));
        QTest::mouseClick(table().viewport(), Qt::LeftButton, modifiers,
                          table().visualRect(nets().index(row, NetModel::Name)).center());
    }

    std::unique_ptr<WindowFixture> m_fixture;
};

QTEST_MAIN(NetsTest)
#include "nets_test.moc"
