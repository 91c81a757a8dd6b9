#include "ui/common/elided_label.h"

#include <QHBoxLayout>
#include <QHelpEvent>
#include <QToolTip>
#include <QtTest>

using ui::ElidedLabel;

class ElidedLabelTest : public QObject {
    Q_OBJECT

private slots:
    void cleanup() { QToolTip::hideText(); }

    void whatHasRoomIsWhole() {
        label(400);
        QCOMPARE(m_label->shown(), m_label->text());
        QVERIFY(toolTip().isEmpty());
    }

    void whatHasNoneEndsInAnEllipsisAndIsWholeInTheTip() {
        label(60);
        QVERIFY(m_label->shown().endsWith(QStringLiteral("…")));
        QVERIFY(m_label->text().startsWith(m_label->shown().chopped(1)));
        QCOMPARE(toolTip(), m_label->text());
    }

    void severalLinesAreBrokenBetweenWordsAndTheLastIsCut() {
        label(120);
        m_label->setMostLines(2);
        const int line = m_label->fontMetrics().lineSpacing();
        QVERIFY(m_label->hasHeightForWidth());
        QCOMPARE(m_label->heightForWidth(1000), line);
        QCOMPARE(m_label->heightForWidth(120), 2 * line);
        QCOMPARE(m_label->heightForWidth(20), 2 * line);
        QCOMPARE(m_label->shown(), m_label->text());
        QVERIFY(toolTip().isEmpty());
        m_label->setText(m_label->text() + "; and much more, which two lines have no room for");
        QVERIFY2(m_label->shown().startsWith("12 locations, spacing"), qPrintable(m_label->shown()));
        QVERIFY(m_label->shown().endsWith(QStringLiteral("…")));
        QCOMPARE(toolTip(), m_label->text());
    }

    /// In a layout it takes them where its width asks for them.
    void aLabelOfSeveralLinesGrowsWithThem() {
        label(120);
        m_label->setMostLines(2);
        QWidget panel;
        auto* row = new QHBoxLayout(&panel);
        row->setContentsMargins(0, 0, 0, 0);
        row->addWidget(m_label.get());
        m_label->show();
        QCOMPARE(row->heightForWidth(120), 2 * m_label->fontMetrics().lineSpacing());
        m_label->setText("12");
        QCOMPARE(row->heightForWidth(120), m_label->fontMetrics().lineSpacing());
        m_label->setParent(nullptr);
    }

    void itDoesNotWidenWhatItLiesIn() {
        label(60);
        QWidget panel;
        auto* row = new QHBoxLayout(&panel);
        row->addWidget(m_label.get());
        QVERIFY(panel.minimumSizeHint().width() < 60);
        m_label->setParent(nullptr);
    }

private:
    void label(int width) {
        m_label = std::make_unique<ElidedLabel>();
        m_label->setText("12 locations, spacing 0.1 mm");
        m_label->resize(width, 20);
        m_label->show();
        QVERIFY(QTest::qWaitForWindowExposed(m_label.get()));
    }

    [[nodiscard]] QString toolTip() const {
        QHelpEvent event(QEvent::ToolTip, {5, 5}, m_label->mapToGlobal(QPoint(5, 5)));
        QCoreApplication::sendEvent(m_label.get(), &event);
        return QToolTip::isVisible() ? QToolTip::text() : QString();
    }

    std::unique_ptr<ElidedLabel> m_label;
};

QTEST_MAIN(ElidedLabelTest)

#include "elided_label_test.moc"
