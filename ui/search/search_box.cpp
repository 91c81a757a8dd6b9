#include "ui/search/search_box.h"

#include <QAction>
#include <QCoreApplication>
#include <QKeyEvent>
#include <QLineEdit>
#include <QListWidget>
#include <QVBoxLayout>
#include <algorithm>
#include <utility>

#include "ui/workspace/actions.h"

namespace ui {

namespace {

constexpr std::size_t kMost = 50;  // more than anybody reads; typing on is quicker
constexpr QChar kCommandsOnly = '>';

}  // namespace

SearchBox::SearchBox(const ActionSet& actions, QWidget& window)
    : QFrame(&window, Qt::Popup), m_actions(actions), m_window(window), m_line(new QLineEdit), m_list(new QListWidget) {
    setFrameShape(QFrame::StyledPanel);
    m_line->setPlaceholderText(tr("Net, component, U1.5, attribute, layer, 12.5, 30 mm, or > for commands"));
    m_line->setClearButtonEnabled(true);
    m_line->installEventFilter(this);
    m_list->setFocusPolicy(Qt::NoFocus);
    m_list->setUniformItemSizes(true);
    connect(m_line, &QLineEdit::textChanged, this, &SearchBox::update);
    connect(m_line, &QLineEdit::returnPressed, this, &SearchBox::take);
    connect(m_list, &QListWidget::itemClicked, this, &SearchBox::take);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(6, 6, 6, 6);
    layout->addWidget(m_line);
    layout->addWidget(m_list);
}

void SearchBox::setBoard(std::shared_ptr<const model::Document> board) {
    m_search.setBoard(std::move(board));
    if (isVisible()) {
        update();
    }
}

void SearchBox::open(const QString& text) {
    const int width = fontMetrics().averageCharWidth() * 80;
    resize(std::min(width, m_window.width()), fontMetrics().height() * 20);
    move(m_window.mapToGlobal(QPoint((m_window.width() - this->width()) / 2, fontMetrics().height() * 3)));
    m_line->setText(text);
    update();
    show();
    m_line->setFocus();
}

void SearchBox::update() {
    const bool isCommand = m_line->text().startsWith(kCommandsOnly);
    const QString text = m_line->text().mid(isCommand ? 1 : 0).trimmed();
    m_list->clear();
    m_commands.clear();
    m_found = isCommand ? std::vector<Found>{} : m_search.find(text, m_unit, kMost);
    for (const Found& found : m_found) {
        m_list->addItem(QStringLiteral("%1    %2").arg(m_search.titleOf(found, m_unit), m_search.detailOf(found)));
    }
    if (isCommand || !text.isEmpty()) {
        listCommands(text, isCommand);
    }
    if (m_list->count() == 0 && !text.isEmpty()) {
        (new QListWidgetItem(tr("Nothing is called %1").arg(text), m_list))->setFlags(Qt::NoItemFlags);
    }
    m_list->setCurrentRow(0);
}

SearchBox::CommandFit SearchBox::fitOf(const ActionSpec& spec, const QString& text) const {
    const auto hasAllWords = [words = text.split(' ', Qt::SkipEmptyParts)](const QString& in) {
        return std::ranges::all_of(words, [&](const QString& word) { return in.contains(word, Qt::CaseInsensitive); });
    };
    const QString name = m_actions[spec.id].text().remove('&');
    const QString words = ActionSet::tr(spec.words);
    const QString inMenu = menuTitle(spec.menu).remove('&') + ' ' + name;
    const QString all = inMenu + ' ' + m_actions[spec.id].statusTip() + ' ' + words;
    return words.split(' ', Qt::SkipEmptyParts).contains(text, Qt::CaseInsensitive) ? CommandFit::Word
           : name.contains(text, Qt::CaseInsensitive)                               ? CommandFit::Phrase
           : hasAllWords(name + ' ' + words)                                        ? CommandFit::Name
           : hasAllWords(inMenu)                                                    ? CommandFit::Menu
           : hasAllWords(all)                                                       ? CommandFit::Tip
                                                                                    : CommandFit::None;
}

void SearchBox::listCommands(const QString& text, bool areAlone) {
    std::vector<std::pair<CommandFit, const ActionSpec*>> fitting;
    const CommandFit least = areAlone ? CommandFit::Tip : CommandFit::Name;
    for (const ActionSpec& spec : ActionSet::kSpecs) {
        if (const CommandFit fit = fitOf(spec, text); fit <= least) {
            fitting.emplace_back(fit, &spec);
        }
    }
    std::ranges::stable_sort(fitting, {}, &std::pair<CommandFit, const ActionSpec*>::first);
    for (const auto& [fit, spec] : fitting) {
        addCommand(*spec);
    }
}

void SearchBox::addCommand(const ActionSpec& spec) {
    QAction& action = m_actions[spec.id];
    if (!action.isEnabled()) {
        return;
    }
    const QString keys = action.shortcut().toString(QKeySequence::NativeText);
    const QString menu = menuTitle(spec.menu).remove('&');
    m_list->addItem(
        tr("%1    Command, %2%3")
            .arg(action.text().remove('&'), menu, keys.isEmpty() ? QString() : QStringLiteral(", ") + keys));
    m_commands.push_back(&action);
}

void SearchBox::take() {
    const auto at = static_cast<std::size_t>(m_list->currentRow());  // none: beyond all
    if (at >= m_found.size() + m_commands.size()) {
        return;
    }
    close();  // first: a command may open a window of its own
    if (at < m_found.size()) {
        emit chosen(m_found[at]);
    } else {
        m_commands[at - m_found.size()]->trigger();
    }
}

bool SearchBox::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() == QEvent::KeyPress) {
        const int key = static_cast<QKeyEvent*>(event)->key();
        if (key == Qt::Key_Up || key == Qt::Key_Down || key == Qt::Key_PageUp || key == Qt::Key_PageDown) {
            QCoreApplication::sendEvent(m_list, event);
            return true;
        }
        if (key == Qt::Key_Escape) {
            close();
            return true;
        }
    }
    return QFrame::eventFilter(watched, event);
}

}  // namespace ui
