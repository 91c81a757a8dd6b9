#include "ui/shell/guide_window.h"

#include <QCoreApplication>
#include <QDir>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QShortcut>
#include <QTextBrowser>
#include <QToolButton>
#include <QVBoxLayout>

#include "ui/common/first_size.h"

namespace ui {

namespace {

constexpr const char* kFirstPage = "README.md";

QUrl urlOf(const QString& folder, const QString& page) {
    return QUrl::fromLocalFile(folder + '/' + page);
}

QToolButton* button(const QString& text, const QString& tip) {
    auto* button = new QToolButton;
    button->setText(text);
    button->setToolTip(tip);
    return button;
}

}  // namespace

QString guideFolder() {
    return QDir::cleanPath(QCoreApplication::applicationDirPath() + '/' + COPPERSCOPE_RESOURCES + "/guide");
}

GuideWindow::GuideWindow(const QString& folder, QWidget* parent)
    : QDialog(parent), m_folder(folder), m_page(new QTextBrowser), m_words(new QLineEdit), m_result(new QLabel) {
    setWindowTitle(tr("Guide"));
    auto* layout = new QVBoxLayout(this);
    layout->addWidget(controls());
    layout->addWidget(m_page, 1);
    m_page->setObjectName(QStringLiteral("guidePage"));
    m_page->document()->setDocumentMargin(12);
    resizeToScreen(*this,
                   {850, 720});  // the pictures are up to 760 pixels wide, beside them are margins and a scroll bar
    showContents();
    m_page->setFocus();
}

void GuideWindow::showContents() {
    if (QFileInfo::exists(m_folder + '/' + kFirstPage)) {
        m_page->setSource(urlOf(m_folder, kFirstPage));
    } else {
        m_page->setPlainText(
            tr("The guide is not installed: it belongs into %1").arg(QDir::toNativeSeparators(m_folder)));
    }
}

QWidget* GuideWindow::controls() {
    QToolButton* back = button(tr("&Back"), tr("The page before (Alt+Left)"));
    QToolButton* forward = button(tr("&Forward"), tr("The page after, once you went back (Alt+Right)"));
    QToolButton* contents = button(tr("&Contents"), tr("The first page"));
    connect(back, &QToolButton::clicked, m_page, &QTextBrowser::backward);
    connect(forward, &QToolButton::clicked, m_page, &QTextBrowser::forward);
    connect(contents, &QToolButton::clicked, this, &GuideWindow::showContents);
    connect(m_page, &QTextBrowser::backwardAvailable, back, &QWidget::setEnabled);
    connect(m_page, &QTextBrowser::forwardAvailable, forward, &QWidget::setEnabled);
    back->setEnabled(false);
    forward->setEnabled(false);
    m_words->setPlaceholderText(tr("Find in the guide (Ctrl+F)"));
    m_words->setAccessibleName(tr("Find in the guide"));
    m_words->setClearButtonEnabled(true);
    connect(m_words, &QLineEdit::returnPressed, this, [this] { find(m_words->text()); });
    connect(new QShortcut(QKeySequence::Find, this), &QShortcut::activated, m_words, [this] { m_words->setFocus(); });
    auto* row = new QWidget;
    auto* layout = new QHBoxLayout(row);
    layout->setContentsMargins(0, 0, 0, 0);
    for (QWidget* part : std::initializer_list<QWidget*>{back, forward, contents}) {
        layout->addWidget(part);
    }
    layout->addWidget(m_result, 1, Qt::AlignRight);
    layout->addWidget(m_words, 1);
    return row;
}

bool GuideWindow::find(const QString& words) {
    m_result->clear();
    if (m_page->find(words)) {
        return true;
    }
    const QStringList pages = QDir(m_folder).entryList({QStringLiteral("*.md")}, QDir::Files, QDir::Name);
    const qsizetype here = pages.indexOf(m_page->source().fileName());
    for (qsizetype step = 1; step <= pages.size(); ++step) {
        QTextDocument page;
        QFile file(m_folder + '/' + pages[(here + step) % pages.size()]);
        if (!file.open(QIODevice::ReadOnly)) {
            continue;
        }
        page.setMarkdown(QString::fromUtf8(file.readAll()));
        if (!page.find(words).isNull()) {
            m_page->setSource(QUrl::fromLocalFile(file.fileName()));
            m_page->moveCursor(QTextCursor::Start);
            return m_page->find(words);
        }
    }
    m_result->setText(tr("Not found"));
    return false;
}

void showGuide(QWidget& parent) {
    auto* guide = parent.findChild<GuideWindow*>();
    if (guide == nullptr) {
        guide = new GuideWindow(guideFolder(), &parent);
    }
    guide->show();
    guide->raise();
    guide->activateWindow();
}

}  // namespace ui
