// Where the table of the Nets panel is scrolled to: what is found stays in sight, another board and another order begin
// at the top.

#include <QFile>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QScrollBar>
#include <QtTest>

#include "tests/patience.h"
#include "tests/ui/window_fixture.h"

using ui::NetModel;

class NetInSightTest : public QObject {
    Q_OBJECT

private slots:
    void init() {
        m_fixture = std::make_unique<WindowFixture>();
        open(boardOf("many", 200));
        window().showPanel("nets");
    }
    void cleanup() { QCOMPARE(validationErrorsOnClosing(m_fixture), 0U); }

    /// What is known of the net opens below the table once its row is there.
    void aNetThatIsFoundIsInSightAboveItsDetails() {
        const int before = table().viewport()->height();
        find("NET150");
        QTRY_VERIFY(details().isVisible() && table().viewport()->height() < before);
        QVERIFY(isInSight("NET150"));
        QVERIFY2(table().verticalScrollBar()->value() > 0, "it was not from the first");
    }

    void anotherBoardBeginsAtItsTop() {
        find("NET190");
        QTRY_VERIFY(table().verticalScrollBar()->value() > 0);
        open(boardOf("others", 160));
        QVERIFY(nets().rowCount() >= 160 && nets().rowCount() < 190);
        QTRY_VERIFY(table().verticalScrollBar()->maximum() > 0);
        QCOMPARE(table().verticalScrollBar()->value(), 0);
        QVERIFY(isInSight("NET001"));
    }

    void aListThatIsSortedBeginsAtItsTop() {
        find("NET150");
        QTRY_VERIFY(details().isVisible() && table().verticalScrollBar()->value() > 0);
        const QHeaderView& header = *table().horizontalHeader();
        const QPoint heading(header.sectionViewportPosition(NetModel::Name) + 20, header.height() / 2);
        QTest::mouseClick(header.viewport(), Qt::LeftButton, {}, heading);
        QTRY_VERIFY(nets().isArranged() && isInSight("NET200"));
        QCOMPARE(table().verticalScrollBar()->value(), 0);
    }

    void aBoardThatIsReadAnewShowsTheNetThatIsStillChosen() {
        find("NET150");
        QTRY_VERIFY(details().isVisible());
        const model::Document* before = window().document();
        window().actions()[ui::ActionId::Reload].trigger();
        QTRY_VERIFY(window().document() != before && !window().loader().isLoading());
        QTRY_VERIFY(nets().isArranged() && nets().rowCount() >= 200);
        QCOMPARE(window().selection().nets().size(), std::size_t{1});
        QTRY_VERIFY(details().isVisible());
        QTRY_VERIFY(isInSight("NET150"));
    }

private:
    TestWindow& window() { return m_fixture->window(); }
    NetModel& nets() { return window().nets(); }
    ui::TableView& table() { return window().netsPanel().table(); }
    QLabel& details() { return *window().netsPanel().findChild<QLabel*>("netDetails"); }

    void open(const QString& path) {
        QVERIFY(m_fixture->openAndWait(path));
        QTRY_VERIFY(nets().isArranged());
    }
    void find(const char* name) {
        m_fixture->key(Qt::Key_F, Qt::ControlModifier);
        QLineEdit& line = window().searchBox().line();
        line.clear();
        QTest::keyClicks(&line, name);
        QTest::keyClick(&line, Qt::Key_Return);
    }
    bool isInSight(const char* name) {
        const std::optional<int> row = nets().rowOf(window().document()->findNet(name));
        const QRect cell = row ? table().visualRect(nets().index(*row, NetModel::Name)) : QRect();
        return cell.isValid() && cell.top() >= 0 && cell.bottom() < table().viewport()->height();
    }
    /// NET001 to so many, a track each.
    QString boardOf(const QString& name, int count) {
        QString names;
        QString tracks;
        for (int i = 1; i <= count; ++i) {
            names += QStringLiteral("(net %1 \"NET%2\") ").arg(i).arg(i, 3, 10, QLatin1Char('0'));
            tracks +=
                QStringLiteral("(segment (start 2 %1) (end 18 %1) (width 0.2) (layer \"F.Cu\") (net %1)) ").arg(i);
        }
        const QString path = m_fixture->folder() + '/' + name + ".kicad_pcb";
        QFile file(path);
        if (file.open(QFile::WriteOnly)) {
            file.write(
                QStringLiteral("(kicad_pcb (version 20241229) (generator \"pcbnew\") (layers (0 \"F.Cu\" signal) "
                               "(2 \"B.Cu\" signal) (25 \"Edge.Cuts\" user)) (net 0 \"\") %1 %2 "
                               "(gr_rect (start 0 0) (end 20 %3) (stroke (width 0.1) (type default)) (fill no) "
                               "(layer \"Edge.Cuts\")))")
                    .arg(names, tracks)
                    .arg(count + 1)
                    .toUtf8());
        }
        return path;
    }

    std::unique_ptr<WindowFixture> m_fixture;
};

QTEST_MAIN(NetInSightTest)
#include "net_in_sight_test.moc"
