#include "ui/assignment/assignment_model.h"

#include <QSignalSpy>
#include <QtTest>

using model::gerber::LayerProposal;
using ui::AssignmentModel;

namespace {

LayerProposal proposal(const char* path, const char* words, const char* content = "image", const char* board = "") {
    LayerProposal made{path, content, *model::gerber::roleOfWords(words), words, "its name", board, true};
    return made;
}

LayerProposal unknown(const char* path) {
    return {path, "image", {}, "", "nothing tells", "", false};
}

}  // namespace

/// Edits of what files draw, as the table takes them.
class AssignmentModelTest : public QObject {
    Q_OBJECT

private slots:
    void copperIsNumberedWithoutHoles() {
        AssignmentModel model;
        model.setProposals({proposal("top", "copper top 1"), proposal("in1", "copper inner 2"),
                            proposal("in2", "copper inner 3"), proposal("bottom", "copper bottom 4"), unknown("new")});
        QCOMPARE(wordsOf(model, "new"), "document");
        // Told as copper, it lies above the bottom one.
        QVERIFY(set(model, "new", AssignmentModel::Draws, "Copper"));
        QCOMPARE(wordsOf(model, "new"), "copper inner 4");
        QCOMPARE(wordsOf(model, "bottom"), "copper bottom 5");
        // Moved to the top, what was there is an inner one.
        QVERIFY(set(model, "in2", AssignmentModel::Number, "1"));
        QCOMPARE(wordsOf(model, "in2"), "copper top 1");
        QCOMPARE(wordsOf(model, "top"), "copper inner 2");
        QCOMPARE(wordsOf(model, "in1"), "copper inner 3");
        QVERIFY(set(model, "in2", AssignmentModel::Side, "Inner"));
        QCOMPARE(wordsOf(model, "in2"), "copper inner 2");
        QCOMPARE(wordsOf(model, "top"), "copper top 1");
        QVERIFY(set(model, "top", AssignmentModel::Side, "Bottom"));
        QCOMPARE(wordsOf(model, "top"), "copper bottom 5");
        QCOMPARE(wordsOf(model, "in2"), "copper top 1");
        // Left out, the others close up.
        QVERIFY(set(model, "in1", AssignmentModel::Draws, "Left out"));
        QCOMPARE(wordsOf(model, "in1"), "ignore");
        QCOMPARE(wordsOf(model, "top"), "copper bottom 4");
    }

    void negativeCopperKeepsItsPlace() {
        AssignmentModel model;
        model.setProposals(
            {proposal("a", "copper top 1"), proposal("b", "copper inner 2"), proposal("c", "copper bottom 3")});
        QVERIFY(set(model, "b", AssignmentModel::Draws, "Copper, negative"));
        QCOMPARE(wordsOf(model, "b"), "copper inner 2 negative");
        QVERIFY(set(model, "b", AssignmentModel::Draws, "Copper"));
        QCOMPARE(wordsOf(model, "b"), "copper inner 2");
    }

    void copperOfOtherBoardsStaysAsItIs() {
        AssignmentModel model;
        model.setProposals({proposal("a", "copper top 1", "image", "one"),
                            proposal("b", "copper bottom 2", "image", "one"),
                            proposal("c", "copper top 1", "image", "two")});
        QVERIFY(model.hasBoards());
        QVERIFY(set(model, "a", AssignmentModel::Number, "2"));
        QCOMPARE(wordsOf(model, "b"), "copper top 1");
        QCOMPARE(wordsOf(model, "c"), "copper top 1");
        QVERIFY(set(model, "c", AssignmentModel::Side, "Bottom"));
        QCOMPARE(wordsOf(model, "c"), "copper bottom 1");
    }

    void drillsHavePlatingAndASpan() {
        AssignmentModel model;
        model.setProposals(
            {proposal("a", "copper top 1"), proposal("b", "copper bottom 2"), proposal("d", "drill", "drills")});
        QVERIFY(set(model, "d", AssignmentModel::Plated, "Not plated"));
        QVERIFY(set(model, "d", AssignmentModel::Span, "1-2"));
        QCOMPARE(wordsOf(model, "d"), "drill non-plated 1-2");
        QVERIFY(set(model, "d", AssignmentModel::Draws, "Routed slots"));
        QCOMPARE(wordsOf(model, "d"), "rout non-plated 1-2");
        QVERIFY(set(model, "d", AssignmentModel::Span, ""));
        QVERIFY(set(model, "d", AssignmentModel::Plated, "Not said"));
        QCOMPARE(wordsOf(model, "d"), "rout");
    }

    void whatCannotBeIsRefusedWithAReason_data() {
        QTest::addColumn<QString>("file");
        QTest::addColumn<int>("column");
        QTest::addColumn<QString>("value");
        QTest::newRow("no such thing") << "a" << int(AssignmentModel::Draws) << "Gold";
        QTest::newRow("no such layer") << "a" << int(AssignmentModel::Number) << "3";
        QTest::newRow("no number") << "a" << int(AssignmentModel::Number) << "x";
        QTest::newRow("layer 0") << "a" << int(AssignmentModel::Number) << "0";
        QTest::newRow("no inner side of two") << "a" << int(AssignmentModel::Side) << "Inner";
        QTest::newRow("span beyond the board") << "d" << int(AssignmentModel::Span) << "1-3";
        QTest::newRow("span of words") << "d" << int(AssignmentModel::Span) << "plated";
        QTest::newRow("span of one number") << "d" << int(AssignmentModel::Span) << "2";
        QTest::newRow("plated otherwise") << "d" << int(AssignmentModel::Plated) << "Gold";
    }
    void whatCannotBeIsRefusedWithAReason() {
        QFETCH(QString, file);
        QFETCH(int, column);
        QFETCH(QString, value);
        AssignmentModel model;
        model.setProposals(
            {proposal("a", "copper top 1"), proposal("b", "copper bottom 2"), proposal("d", "drill", "drills")});
        QSignalSpy refused(&model, &AssignmentModel::refused);
        const std::string before = wordsOf(model, file);
        QVERIFY(!set(model, file, column, value));
        QCOMPARE(refused.count(), 1);
        QVERIFY(!refused[0][0].toString().isEmpty());
        QCOMPARE(wordsOf(model, file), before);
    }

    void cellsThatMeanNothingCannotBeEdited() {
        AssignmentModel model;
        model.setProposals({proposal("m", "solder-mask top"), proposal("d", "drill", "drills")});
        const auto canEdit = [&](int row, int column) {
            return model.index(row, column).flags().testFlag(Qt::ItemIsEditable);
        };
        QVERIFY(canEdit(0, AssignmentModel::Draws) && canEdit(0, AssignmentModel::Side));
        QVERIFY(!canEdit(0, AssignmentModel::Number) && !canEdit(0, AssignmentModel::Plated));
        QVERIFY(canEdit(1, AssignmentModel::Plated) && canEdit(1, AssignmentModel::Span));
        QVERIFY(!canEdit(1, AssignmentModel::Side) && !canEdit(1, AssignmentModel::File));
    }

    void netlistsAreOnlyLeftOut() {
        AssignmentModel model;
        model.setProposals({proposal("a", "copper top 1"),
                            {"n.ipc", "netlist", {}, "", "its content", "", true},
                            {"readme", "other", {}, "", "its content", "", true}});
        QCOMPARE(model.rowCount(), 2);
        QCOMPARE(model.index(1, AssignmentModel::Draws).data(ui::TableModel::kChoicesRole).toStringList().size(), 2);
        QVERIFY(!set(model, "n.ipc", AssignmentModel::Draws, "Copper"));
        QVERIFY(set(model, "n.ipc", AssignmentModel::Draws, "Left out"));
        QCOMPARE(wordsOf(model, "n.ipc"), "ignore");
        QCOMPARE(model::gerber::mapOf(model.proposals()).rows().size(), std::size_t(2));
        QVERIFY(set(model, "n.ipc", AssignmentModel::Draws, "Nothing: netlist"));
        QCOMPARE(model::gerber::mapOf(model.proposals()).rows().size(), std::size_t(1));
    }

private:
    static bool set(AssignmentModel& model, const QString& file, int column, const QString& value) {
        for (int row = 0; row < model.rowCount(); ++row) {
            if (model.index(row, AssignmentModel::File).data().toString() == file) {
                return model.setData(model.index(row, column), value, Qt::EditRole);
            }
        }
        return false;
    }
    static std::string wordsOf(const AssignmentModel& model, const QString& file) {
        const auto& all = model.proposals();
        const auto found = std::ranges::find(all, file.toStdString(), &LayerProposal::path);
        return found == all.end() ? "none" : model::gerber::wordsOf(found->role);
    }
};

QTEST_GUILESS_MAIN(AssignmentModelTest)
#include "assignment_model_test.moc"
