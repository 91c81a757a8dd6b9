#pragma once

#include <QComboBox>
#include <QMouseEvent>
#include <QtTest>
#include <algorithm>
#include <memory>

#include "tests/ui/window_fixture.h"
#include "ui/section/section_feature.h"

/// The window with the sample board, no line of a section yet, and mouse events for its 2D view.
class SectionFixture {
protected:
    /// Once.
    void open() {
        m_fixture = std::make_unique<WindowFixture>();
        m_board = m_fixture->copyOfSample();
        QVERIFY(m_fixture->openAndWait(m_board));
        base::Progress progress;
        const auto board = std::make_shared<const model::Document>(*window().document());
        m_index = *model::indexBoard(board, progress);
    }
    /// Before each test.
    void reset() {
        sections().cutAlong({});
        window().selection().select({});
        flat().controller().look(render::NamedView::Top);
        window().find<ui::SectionPanel>().heightsBox().setCurrentIndex(0);
    }

    [[nodiscard]] TestWindow& window() { return m_fixture->window(); }
    [[nodiscard]] ui::SectionFeature& sections() { return window().sections(); }
    [[nodiscard]] ui::SectionView& view() { return window().find<ui::SectionPanel>().view(); }
    [[nodiscard]] ui::BoardView& flat() { return window().views().flat(); }

    static bool isAt(base::PointD a, base::PointD b) { return a.x == b.x && a.y == b.y; }
    static bool same(const std::vector<model::SectionPiece>& a, const std::vector<model::SectionPiece>& b) {
        return std::ranges::equal(a, b, [](const model::SectionPiece& p, const model::SectionPiece& q) {
            return p.layer == q.layer && p.at == q.at && p.from == q.from && p.to == q.to && p.bottom == q.bottom &&
                   p.top == q.top;
        });
    }
    /// What the line of the window cuts.
    [[nodiscard]] model::Section expected() {
        model::SectionRequest request{window().find<ui::SectionLine>().line(), {}};
        request.milled = render::milledOfSteps(*window().workspace().board()->model);
        return *model::makeSection(*m_index, request);
    }

    /// From one edge of the board to the other through its middle, in pixels of the 2D view.
    [[nodiscard]] std::pair<QPointF, QPointF> acrossBoard() {
        const model::Box& board = m_index->board->board;
        const double y = (double{1} * board.min.y + board.max.y) / 2;
        const auto at = [&](double x) {
            return *flat().controller().screenOf(window().probing().position().toModel({x, y}));
        };
        return {at(board.min.x), at(board.max.x)};
    }
    void drawLine() {
        const auto [from, to] = acrossBoard();
        m_fixture->key(Qt::Key_S, Qt::ShiftModifier);
        mouse(QEvent::MouseButtonPress, from);
        mouse(QEvent::MouseMove, to);
        mouse(QEvent::MouseButtonRelease, to);
        QVERIFY(view().section().has_value());
    }
    void mouse(QEvent::Type type, QPointF at, Qt::KeyboardModifiers modifiers = Qt::NoModifier) {
        const bool isMove = type == QEvent::MouseMove;
        QMouseEvent event(type, at, flat().mapToGlobal(at), isMove ? Qt::NoButton : Qt::LeftButton,
                          type == QEvent::MouseButtonRelease ? Qt::NoButton : Qt::LeftButton, modifiers);
        QCoreApplication::sendEvent(&flat().canvas(), &event);
    }

    std::unique_ptr<WindowFixture> m_fixture;
    QString m_board;
    std::shared_ptr<const model::BoardIndex> m_index;
};
