#include "ui/common/sorted_rows.h"

#include <QtTest>

namespace {

class Words : public ui::TableModel {
public:
    Words() : TableModel({{"Word", "A word"}}) {}

    void change(int row, const QString& word) {
        m_words[row] = word;
        announceChange();
    }
    void reset(const QStringList& words) {
        beginResetModel();
        m_words = words;
        endResetModel();
    }
    [[nodiscard]] int asked() const { return m_asked; }

private:
    [[nodiscard]] int rows() const override { return static_cast<int>(m_words.size()); }
    [[nodiscard]] ui::Cell cell(int row, int /*column*/) const override {
        ++m_asked;
        return {m_words[row]};
    }

    QStringList m_words{"alpha", "beta", "gamma"};
    mutable int m_asked = 0;
};

}  // namespace

class SortedRowsTest : public QObject {
    Q_OBJECT

private slots:
    void rowsWithAllWordsAreShown() {
        m_rows.setWords("A");
        QCOMPARE(shown(), QStringList({"alpha", "beta", "gamma"}));
        m_rows.setWords("a m");
        QCOMPARE(shown(), QStringList{"gamma"});
        m_rows.setWords("");
        QCOMPARE(shown().size(), 3);
    }

    void textsAreMadeOnce() {
        m_rows.setWords("a");
        const int before = m_words.asked();
        m_rows.setWords("al");
        m_rows.setWords("zeta");
        QCOMPARE(m_words.asked(), before);
    }

    void whatChangesIsLookedAtAgain() {
        m_rows.setWords("zeta");
        QVERIFY(shown().isEmpty());
        m_words.change(1, "zeta");
        QCOMPARE(shown(), QStringList{"zeta"});
        m_words.reset({"one", "zeta", "two", "zeta too"});
        QCOMPARE(shown(), QStringList({"zeta", "zeta too"}));
    }

private:
    [[nodiscard]] QStringList shown() const {
        QStringList texts;
        for (int row = 0; row < m_rows.rowCount(); ++row) {
            texts += m_rows.index(row, 0).data().toString();
        }
        return texts;
    }

    Words m_words;
    ui::SortedRows m_rows{m_words};
};

QTEST_GUILESS_MAIN(SortedRowsTest)
#include "sorted_rows_test.moc"
