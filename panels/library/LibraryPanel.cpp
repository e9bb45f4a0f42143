// SPDX-License-Identifier: GPL-3.0-or-later
#include "panels/library/LibraryPanel.h"

#include "panels/Icon.h"
#include "panels/Theme.h"
#include "panels/library/LibraryView.h"

#include <QActionGroup>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QPainter>
#include <QPushButton>

namespace espalier {

namespace {

constexpr int kSide = 26; ///< px left and right of all
constexpr int kSearchWidth = 250;

void dim(QLabel& label)
{
    theme::setTone(label, theme::Tone::Dim);
    label.setTextFormat(Qt::PlainText);
}

} // namespace

LibraryPanel::LibraryPanel(const PictureReader& readPicture, QWidget* parent)
    : Bar(parent),
      m_view(new CardView(this)),
      m_search(new QLineEdit(this)),
      m_keep(new QPushButton(tr("Keep This Tree"), this)),
      m_empty(new QLabel(this)),
      m_name(new QLabel(this)),
      m_line(new QLabel(this)),
      m_start(new QPushButton(tr("Start from This"), this)),
      m_open(new QPushButton(tr("Open"), this))
{
    setFlat(true);
    setAccessibleName(tr("Library"));
    for (std::size_t i = 0; i < kSections; ++i) {
        m_cards[i] = new LibraryCards(static_cast<Section>(i) == Section::Trees, readPicture, this);
        m_found[i] = new LibrarySearch(this);
        m_found[i]->setSourceModel(m_cards[i]);
        connect(m_cards[i], &LibraryCards::renameAsked, this, &LibraryPanel::renameAsked);
    }
    m_view->setObjectName(QStringLiteral("cards"));
    m_view->setAccessibleName(tr("Trees"));
    m_empty->setAlignment(Qt::AlignCenter);
    m_empty->setWordWrap(true);
    dim(*m_empty);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(kSide, 14, kSide, 14);
    column->setSpacing(10);
    column->addLayout(makeHeader());
    column->addWidget(m_view, 1);
    column->addWidget(m_empty, 1);
    column->addLayout(makeFooter());

    const auto ask = [this](void (LibraryPanel::*what)(const QString&)) {
        return [this, what] {
            if (!chosen().isEmpty())
                Q_EMIT(this->*what)(chosen());
        };
    };
    connect(m_open, &QPushButton::clicked, this, ask(&LibraryPanel::openAsked));
    connect(m_start, &QPushButton::clicked, this, ask(&LibraryPanel::startAsked));
    connect(m_keep, &QPushButton::clicked, this, &LibraryPanel::keepAsked);
    connect(m_search, &QLineEdit::textChanged, this, &LibraryPanel::search);
    connect(m_view, &QListView::activated, this, ask(&LibraryPanel::openAsked));
    connect(m_view, &CardView::typed, this, [this](const QString& text) {
        m_search->setFocus();
        m_search->insert(text);
    });
    connect(m_view, &CardView::deleteAsked, this, [this] {
        if (m_section == Section::Trees)
            Q_EMIT trashAsked(chosen());
    });
    connect(m_view, &CardView::menuAsked, this, [this](const QModelIndex& index, const QPoint& place) {
        m_view->setCurrentIndex(index);
        auto* menu = new QMenu(this);
        menu->setAttribute(Qt::WA_DeleteOnClose);
        fillMenu(*menu, chosen());
        menu->popup(place);
    });
    showSection(Section::Species);
}

QLayout* LibraryPanel::makeHeader()
{
    auto* line = new QHBoxLayout;
    line->setSpacing(4);
    auto* title = barHeading(tr("Library"), this);
    QFont large = title->font();
    large.setPointSizeF(large.pointSizeF() * 1.3);
    title->setFont(large);
    title->setFixedHeight(theme::kTarget);
    title->setAlignment(Qt::AlignVCenter | Qt::AlignLeft);
    line->addWidget(title);
    line->addSpacing(18);
    auto* group = new QActionGroup(this);
    for (std::size_t i = 0; i < kSections; ++i) {
        m_tabs[i] = new QAction(this);
        m_tabs[i]->setObjectName(i == 0 ? QStringLiteral("species") : QStringLiteral("trees"));
        m_tabs[i]->setCheckable(true);
        group->addAction(m_tabs[i]);
        connect(m_tabs[i], &QAction::triggered, this, [this, i] { showSection(static_cast<Section>(i)); });
        line->addWidget(new BarButton(BarButton::Look::Tab, m_tabs[i], this));
    }
    line->addStretch(1);
    m_search->setPlaceholderText(tr("Search"));
    m_search->setAccessibleName(tr("Search"));
    m_search->setClearButtonEnabled(true);
    m_search->setFixedSize(kSearchWidth, theme::kTarget);
    line->addWidget(m_search);
    line->addSpacing(8);
    m_keep->setObjectName(QStringLiteral("keep"));
    m_keep->setToolTip(tr("Save the open tree in the library."));
    m_keep->setMinimumHeight(theme::kTarget);
    line->addWidget(m_keep);
    auto* close = new BarButton(BarButton::Look::Icon, this);
    close->setIcon(icon(QStringLiteral("close")));
    close->setToolTip(tr("Back to the tree"));
    close->setAccessibleName(tr("Close"));
    connect(close, &QToolButton::clicked, this, &LibraryPanel::closeAsked);
    line->addWidget(close);
    return line;
}

QLayout* LibraryPanel::makeFooter()
{
    auto* line = new QHBoxLayout;
    line->setSpacing(10);
    auto* words = new QVBoxLayout;
    words->setSpacing(0);
    m_name->setTextFormat(Qt::PlainText);
    QFont bold = m_name->font();
    bold.setBold(true);
    m_name->setFont(bold);
    dim(*m_line);
    m_line->setWordWrap(true);
    m_line->setFixedHeight(2 * m_line->fontMetrics().lineSpacing() + 2);
    m_line->setAlignment(Qt::AlignTop | Qt::AlignLeft);
    words->addWidget(m_name);
    words->addWidget(m_line);
    line->addLayout(words, 1);
    m_start->setToolTip(tr("A new seedling that grows the way this tree does."));
    m_open->setDefault(true);
    for (QPushButton* button : {m_start, m_open}) {
        button->setMinimumSize(120, theme::kTarget);
        button->setAutoDefault(false);
        line->addWidget(button);
    }
    m_start->setObjectName(QStringLiteral("start"));
    m_open->setObjectName(QStringLiteral("open"));
    return line;
}

void LibraryPanel::setEntries(Section section, std::vector<LibraryEntry> entries)
{
    const QString before = chosen();
    m_cards[static_cast<std::size_t>(section)]->setEntries(std::move(entries));
    if (section == m_section)
        choose(before);
    showWhatIsThere();
}

void LibraryPanel::showSection(Section section)
{
    m_section = section;
    m_tabs[static_cast<std::size_t>(section)]->setChecked(true);
    if (m_view->model() != &found()) {
        QItemSelectionModel* const before = m_view->selectionModel();
        m_view->setModel(&found());
        delete before;
        connect(m_view->selectionModel(), &QItemSelectionModel::currentChanged, this,
                &LibraryPanel::followChosen);
    }
    choose({});
    showWhatIsThere();
}

void LibraryPanel::choose(const QString& fileName)
{
    const int row = cards().rowOf(fileName);
    QModelIndex index = row < 0 ? QModelIndex() : found().mapFromSource(cards().index(row));
    if (!index.isValid())
        index = found().index(0, 0);
    m_view->setCurrentIndex(index);
    if (index.isValid())
        m_view->scrollTo(index);
    followChosen();
}

void LibraryPanel::editName()
{
    m_view->setFocus();
    if (m_view->currentIndex().isValid())
        m_view->edit(m_view->currentIndex());
}

QString LibraryPanel::chosen() const
{
    return m_view->currentIndex().data(LibraryCards::FileRole).toString();
}

void LibraryPanel::setMayKeep(bool may)
{
    m_keep->setEnabled(may);
}

void LibraryPanel::takeFocus()
{
    m_view->setFocus();
}

void LibraryPanel::followChosen()
{
    const QModelIndex index = m_view->currentIndex();
    m_name->setText(index.data().toString());
    m_line->setText(index.data(LibraryCards::LineRole).toString());
    for (QPushButton* button : {m_start, m_open})
        button->setEnabled(index.isValid());
}

void LibraryPanel::search(const QString& text)
{
    const QString before = chosen();
    for (LibrarySearch* found : m_found)
        found->setWords(text);
    choose(before);
    showWhatIsThere();
}

void LibraryPanel::showWhatIsThere()
{
    const QString names[] = {tr("Species"), tr("Your Trees")};
    for (std::size_t i = 0; i < kSections; ++i)
        m_tabs[i]->setText(QStringLiteral("%1  %L2").arg(names[i]).arg(m_found[i]->rowCount()));
    const bool isEmpty = found().rowCount() == 0;
    m_view->setVisible(!isEmpty);
    m_empty->setVisible(isEmpty);
    if (cards().rowCount() > 0)
        m_empty->setText(tr("No tree has a name like that."));
    else if (m_section == Section::Trees)
        m_empty->setText(tr("No trees yet. “Keep This Tree” saves the open tree here."));
    else
        m_empty->clear();
    followChosen();
}

void LibraryPanel::fillMenu(QMenu& menu, const QString& fileName)
{
    menu.addAction(tr("Open"), this, [this, fileName] { Q_EMIT openAsked(fileName); });
    menu.addAction(tr("Start from This"), this, [this, fileName] { Q_EMIT startAsked(fileName); });
    if (m_section == Section::Species)
        return;
    menu.addSeparator();
    QAction* rename = menu.addAction(tr("Rename"), this, &LibraryPanel::editName);
    rename->setShortcut(Qt::Key_F2);
    menu.addAction(tr("Duplicate"), this, [this, fileName] { Q_EMIT duplicateAsked(fileName); });
    QAction* trash =
        menu.addAction(tr("Move to Trash"), this, [this, fileName] { Q_EMIT trashAsked(fileName); });
    trash->setShortcut(Qt::Key_Delete);
}

bool LibraryPanel::event(QEvent* event)
{
    // While the library is open, these keys belong to it and not to the tools.
    if (event->type() == QEvent::ShortcutOverride) {
        const auto* key = static_cast<QKeyEvent*>(event);
        const bool isPlain = !(key->modifiers() & (Qt::ControlModifier | Qt::AltModifier | Qt::MetaModifier));
        const bool isFunctionKey =
            key->key() >= Qt::Key_F1 && key->key() <= Qt::Key_F35 && key->key() != Qt::Key_F2;
        if ((isPlain && !isFunctionKey) || key->matches(QKeySequence::Find)) {
            event->accept();
            return true;
        }
    }
    return Bar::event(event);
}

void LibraryPanel::keyPressEvent(QKeyEvent* event)
{
    if (event->matches(QKeySequence::Find)) {
        m_search->setFocus();
        m_search->selectAll();
    } else if (event->key() == Qt::Key_Escape) {
        if (m_search->text().isEmpty()) {
            Q_EMIT closeAsked();
            return;
        }
        m_search->clear();
        m_view->setFocus();
    } else if (m_search->hasFocus() && (event->key() == Qt::Key_Down || event->key() == Qt::Key_Return)) {
        m_view->setFocus();
    } else {
        Bar::keyPressEvent(event);
    }
}

void LibraryPanel::showEvent(QShowEvent* event)
{
    // When the library opens again, it shows all cards.
    m_search->clear();
    Bar::showEvent(event);
}

void LibraryPanel::paintEvent(QPaintEvent*)
{
    QPainter painter(this);
    painter.fillRect(rect(), theme::kWorkspace);
}

} // namespace espalier
