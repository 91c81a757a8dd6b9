// Sections that are saved with the board: their list, and what is done with them.
#include <QAction>
#include <QClipboard>
#include <QGuiApplication>
#include <QLineEdit>
#include <QProxyStyle>
#include <QSignalSpy>
#include <QtTest>

#include "model/session/session.h"
#include "tests/patience.h"
#include "tests/ui/section/section_fixture.h"
#include "tests/ui/window_fixture.h"
#include "ui/common/table_view.h"
#include "ui/section/section_panel.h"

using base::PointD;
using ui::ActionId;

namespace {

/// A desktop on which one click opens what is clicked.
class OneClickStyle : public QProxyStyle {
public:
    int styleHint(StyleHint hint, const QStyleOption* option, const QWidget* widget,
                  QStyleHintReturn* data) const override {
        return hint == SH_ItemView_ActivateItemOnSingleClick ? 1 : QProxyStyle::styleHint(hint, option, widget, data);
    }
};

}  // namespace

class SavedSectionsTest : public QObject, protected SectionFixture {
    Q_OBJECT

private slots:
    void initTestCase() { open(); }
    void init() { reset(); }
    void cleanupTestCase() { QCOMPARE(validationErrorsOnClosing(m_fixture), 0U); }

    void savedSectionsAreListedOnceThereAreSome() {
        ui::TableView& list = this->list();
        drawLine();
        QVERIFY(window().find<ui::SectionPanel>().isVisible() && !list.isVisible());
        m_fixture->key(Qt::Key_B, Qt::ControlModifier | Qt::AltModifier);
        QVERIFY(list.isVisible());
        emit list.deleteRequested({0});
        QVERIFY(!list.isVisible());
    }

    void sectionsAreShownByEnterAndByTheMenuAndRenamedByF2Alone() {
        drawLine();
        m_fixture->key(Qt::Key_B, Qt::ControlModifier | Qt::AltModifier);
        ui::TableView& list = this->list();
        list.setCurrentIndex(list.model()->index(0, 0));
        const auto isEdited = [&] { return list.findChild<QLineEdit*>() != nullptr; };
        const auto isShownBy = [&](const auto& act) {
            sections().cutAlong({});
            act();
            return view().section().has_value();
        };
        QVERIFY(isShownBy([&] { QTest::keyClick(&list, Qt::Key_Return); }));
        QVERIFY(isShownBy([&] { action("Show")->trigger(); }));
        const QPoint middle = list.visualRect(list.currentIndex()).center();
        QVERIFY(isShownBy([&] {
            QTest::mouseClick(list.viewport(), Qt::LeftButton, {}, middle);
            QTest::mouseDClick(list.viewport(), Qt::LeftButton, {}, middle);
        }));
        QVERIFY2(!isEdited(), "the next key would overwrite the name");
        QTest::keyClick(&list, Qt::Key_F2);
        QVERIFY(isEdited());
        QTest::keyClick(list.findChild<QLineEdit*>(), Qt::Key_Escape);
        QTRY_VERIFY(!isEdited());
        action("Rename")->trigger();
        QVERIFY(isEdited());
        QTest::keyClick(list.findChild<QLineEdit*>(), Qt::Key_Escape);
        QTRY_VERIFY(!isEdited());
        action("Delete")->trigger();
        QVERIFY(kept().empty());
    }

    void aClickShowsASectionOnceOnEveryDesktop() {
        drawLine();
        m_fixture->key(Qt::Key_B, Qt::ControlModifier | Qt::AltModifier);
        ui::TableView& list = this->list();
        OneClickStyle style;
        list.setStyle(&style);
        const QSignalSpy chosen(&list, &ui::TableView::rowChosen);
        const QPoint middle = list.visualRect(list.model()->index(0, 0)).center();
        QTest::mouseClick(list.viewport(), Qt::LeftButton, {}, middle);
        list.setStyle(nullptr);
        QCOMPARE(chosen.count(), 1);
        emit list.deleteRequested({0});
        QVERIFY(kept().empty());
    }

    void renamingASectionKeepsItSelectedAndDoesNotShowIt() {
        drawLine();
        m_fixture->key(Qt::Key_B, Qt::ControlModifier | Qt::AltModifier);
        m_fixture->key(Qt::Key_B, Qt::ControlModifier | Qt::AltModifier);
        sections().cutAlong({});
        list().setCurrentIndex(list().model()->index(1, 0));
        QTest::keyClick(&list(), Qt::Key_F2);
        auto* editor = list().findChild<QLineEdit*>();
        QVERIFY(editor != nullptr);
        editor->selectAll();
        QTest::keyClicks(editor, "Second");
        QTest::keyClick(editor, Qt::Key_Return);
        QTRY_COMPARE(kept()[1].name, std::string("Second"));
        QVERIFY2(!view().section(), "the Enter that ends the edit is not for the list");
        QCOMPARE(list().selectedRows(), std::vector<int>{1});
        QTest::keyClick(&list(), Qt::Key_C, Qt::ControlModifier);
        QCOMPARE(QGuiApplication::clipboard()->text(), QString("Second\n"));
        QTest::keyClick(&list(), Qt::Key_Delete);
        QCOMPARE(kept().size(), std::size_t{1});
        QCOMPARE(kept()[0].name, std::string("Section 1"));
        emit list().deleteRequested({0});
    }

    void sectionsAreKeptRenamedShownForgottenAndUndone() {
        m_fixture->key(Qt::Key_B, Qt::ControlModifier | Qt::AltModifier);
        QVERIFY(kept().empty());  // nothing to keep
        drawLine();
        const std::vector<PointD> line = window().find<ui::SectionLine>().line();
        m_fixture->key(Qt::Key_B, Qt::ControlModifier | Qt::AltModifier);
        QCOMPARE(kept().size(), std::size_t{1});
        QAbstractItemModel& names = *list().model();
        QVERIFY(names.setData(names.index(0, 0), "Across"));
        QCOMPARE(kept()[0].name, std::string("Across"));
        QVERIFY(!names.setData(names.index(0, 0), "  "));  // no name: it is refused
        QCOMPARE(names.index(0, 0).data().toString(), QString("Across"));

        sections().cutAlong({});
        const QRect location = list().visualRect(names.index(0, 0));
        QTest::mouseClick(list().viewport(), Qt::LeftButton, {}, location.center());
        QVERIFY(isAt(window().find<ui::SectionLine>().line().front(), line.front()));
        QVERIFY(same(view().section()->pieces, expected().pieces));

        // As another run of the program finds them.
        window().awaitFiles();
        const auto found = model::session::loadSession(m_board.toStdString(), *window().document());
        QVERIFY(found.ignored.empty());
        QCOMPARE(found.session.sections, kept());

        emit list().deleteRequested({0});
        QVERIFY(kept().empty());
        window().actions()[ActionId::Undo].trigger();
        QCOMPARE(kept().size(), std::size_t{1});
        window().actions()[ActionId::Undo].trigger();
        QCOMPARE(kept()[0].name, std::string("Section 1"));
        QVERIFY(m_fixture->openAndWait(m_board));
        QCOMPARE(names.rowCount(), 1);
        window().actions()[ActionId::Undo].trigger();
    }

    void aKeptSectionOfAnotherStepIsNotShown() {
        QVERIFY(m_fixture->openAndWait(m_board));
        QVERIFY(model::session::saveSections(m_board.toStdString(), *window().document(),
                                             {{"Far", "other", {{0, 0}, {1e6, 0}}}}));
        QVERIFY(m_fixture->openAndWait(m_board));
        QCOMPARE(kept().size(), std::size_t{1});
        emit list().rowChosen(0);
        QVERIFY(!view().section());
        QVERIFY(model::session::saveSections(m_board.toStdString(), *window().document(), {}));
    }

    /// As if the session file of another board lay beside this one.
    void keptSectionsOfAnotherBoardAreTold() {
        const std::string here = window().document()->job.step;
        QVERIFY(model::session::saveSections(
            m_board.toStdString(), *window().document(),
            {{"Theirs", "step of another job", {{0, 0}, {1e6, 0}}}, {"Beside", here, {{9e8, 9e8}, {9.1e8, 9e8}}}}));
        QVERIFY(m_fixture->openAndWait(m_board));
        QCOMPARE(kept().size(), std::size_t{2});
        const QSignalSpy reported(&window().workspace(), &ui::Workspace::reported);
        emit list().rowChosen(0);
        QVERIFY(!view().section());
        QCOMPARE(reported.last()[0].toString(),
                 "Theirs is a section of step step of another job, which this board does not have");
        emit list().rowChosen(1);
        QVERIFY(view().section() && view().section()->pieces.empty());
        QVERIFY(window().find<ui::SectionPanel>().notes().contains("meets nothing of the board"));
        QVERIFY(model::session::saveSections(m_board.toStdString(), *window().document(), {}));
    }

private:
    [[nodiscard]] ui::TableView& list() { return window().find<ui::SectionPanel>().list(); }
    /// Of the menu of the list.
    [[nodiscard]] QAction* action(const QString& text) {
        const QList<QAction*> actions = list().actions();
        const auto at = std::ranges::find_if(
            actions, [&](const QAction* each) { return each->text().remove('&').section('\t', 0, 0) == text; });
        return at != actions.end() ? *at : nullptr;
    }
    [[nodiscard]] const std::vector<model::session::SavedSection>& kept() { return window().sections().saved(); }
};

QTEST_MAIN(SavedSectionsTest)
#include "saved_sections_test.moc"
