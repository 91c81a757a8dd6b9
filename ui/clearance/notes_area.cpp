#include "ui/clearance/notes_area.h"

#include <QLabel>
#include <QScrollBar>
#include <algorithm>

namespace ui {

namespace {

constexpr int kMostLines = 3;

}  // namespace

NotesArea::NotesArea(QWidget* parent) : QScrollArea(parent), m_text(new QLabel) {
    m_text->setObjectName(QStringLiteral("notes"));
    m_text->setTextFormat(Qt::PlainText);
    m_text->setAlignment(Qt::AlignLeft | Qt::AlignTop);
    m_text->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);  // long names do not ask for width
    m_text->setWordWrap(true);
    setFrameShape(QFrame::NoFrame);
    setFocusPolicy(Qt::TabFocus);  // to scroll by keys; a click leaves the keyboard where it is
    setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
    setMinimumSize(1, 1);  // that of scroll areas is more than a line
    setWidgetResizable(true);
    setWidget(m_text);
    hide();
}

void NotesArea::setText(const QString& text) {
    m_text->setText(text);
    verticalScrollBar()->setValue(0);
    setVisible(!text.isEmpty());
    updateGeometry();
}

int NotesArea::heightForWidth(int width) const {
    return std::min(m_text->heightForWidth(width), kMostLines * fontMetrics().lineSpacing());
}

}  // namespace ui
