// A click on a message goes to what it is about, in both views.

#include <QStatusBar>
#include <QTableView>
#include <QtTest>
#include <algorithm>

#include "tests/locations.h"
#include "tests/ui/window_fixture.h"
#include "ui/common/table_view.h"
#include "ui/messages/message_model.h"

using model::Diagnostic;
using ui::MessageModel;

class GoToMessageTest : public QObject {
    Q_OBJECT

private slots:
    void init() {
        m_fixture = std::make_unique<WindowFixture>();
        QVERIFY(m_fixture->openAndWait(locations::kTestData + QStringLiteral("/odb/everything")));
        window().showPanel("messages");
        QTest::qWait(50);  // the views are smaller now
    }
    void cleanup() { m_fixture.reset(); }

    void aMessageAboutAnElementShowsIt() {
        const Diagnostic& message = firstThat([](const Diagnostic& entry) { return entry.element.isValid(); });
        const model::Document& board = *window().document();
        const std::size_t layer = board.elements.layer[message.element.row()].row();
        window().layers().hideAll();
        click(message);
        QVERIFY(window().layers().effectiveStyles()[layer].isVisible);
        const model::Box box = board.boxOf(message.element);
        for (ui::BoardView* view : window().views().both()) {
            const glm::vec3 target = view->controller().camera().target();
            // In perspective the near side takes more room, so that the middle of the picture lies a little behind; in
            // 2D it lies aside by half of what the rulers take.
            const float off = view == &window().views().flat() ? 10.0F * view->controller().mmPerPixel() : 1.0F;
            QVERIFY(std::abs(target.x - middleMm(box.min.x, box.max.x, board.board.min.x, board.board.max.x)) < off);
            QVERIFY(std::abs(target.y - middleMm(box.min.y, box.max.y, board.board.min.y, board.board.max.y)) < off);
        }
    }

    void aMessageAboutAFileLeavesTheViewAlone() {
        const Diagnostic& message =
            firstThat([](const Diagnostic& entry) { return !entry.element.isValid() && !entry.location; });
        const glm::mat4 before = window().views().solid().controller().camera().view();
        click(message);
        QCOMPARE(window().views().solid().controller().camera().view(), before);
        QVERIFY(window().statusBar()->currentMessage().contains("not about one location"));
        click(firstThat([](const Diagnostic& entry) { return entry.element.isValid(); }));
        QVERIFY2(window().statusBar()->currentMessage().isEmpty(), "that was the other message");
    }

    void aLongPathLeavesRoomForTheMessage() {
        QTableView& table = window().table("messages");
        model::Diagnostics exported;
        exported.report(model::Severity::Info, std::string(150, 'p') + "/features", 12, "a message of a few words");
        window().find<MessageModel>().setExported(std::move(exported));
        const int room = table.viewport()->width();
        QVERIFY(room > 300);
        QVERIFY(table.columnWidth(MessageModel::Location) <= room / 3);
        QVERIFY2(3 * table.columnWidth(MessageModel::Text) > room,
                 qPrintable(QString::number(table.columnWidth(MessageModel::Text))));
        const MessageModel& messages = window().find<MessageModel>();
        const QModelIndex where = messages.index(messages.rowCount() - 1, MessageModel::Location);
        QVERIFY(where.data(Qt::ToolTipRole).toString().endsWith("features:12"));
    }

private:
    TestWindow& window() { return m_fixture->window(); }

    template <class Rule>
    const Diagnostic& firstThat(const Rule& rule) {
        const auto& entries = window().document()->diagnostics.entries();
        const auto found = std::ranges::find_if(entries, rule);
        if (found == entries.end()) {
            qFatal("the job has no such message");
        }
        return *found;
    }

    /// Clicks on the row that shows this message.
    void click(const Diagnostic& message) {
        QTableView& table = window().table("messages");
        for (int row = 0; row < table.model()->rowCount(); ++row) {
            const QModelIndex text = table.model()->index(row, MessageModel::Text);
            if (text.data().toString().toStdString() == message.text) {
                table.scrollTo(text);
                QTest::mouseClick(table.viewport(), Qt::LeftButton, {}, table.visualRect(text).center());
                return;
            }
        }
        qFatal("the message is not shown");
    }

    /// The middle of a stretch in mm from the middle of the board.
    static float middleMm(model::Nm low, model::Nm high, model::Nm boardLow, model::Nm boardHigh) {
        return static_cast<float>((double(low) + high - boardLow - boardHigh) / 2e6);
    }

    std::unique_ptr<WindowFixture> m_fixture;
};

QTEST_MAIN(GoToMessageTest)
#include "go_to_message_test.moc"
