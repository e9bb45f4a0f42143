// SPDX-License-Identifier: GPL-3.0-or-later
#include "panels/HelpPanel.h"

#include "panels/HelpPage.h"
#include "panels/Icon.h"
#include "panels/Theme.h"

#include <QDesktopServices>
#include <QFile>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QPushButton>
#include <QScroller>
#include <QSignalBlocker>

#include <algorithm>

namespace espalier {

namespace {

constexpr int kLeastWidth = 420; ///< px
constexpr int kMostWidth = 740;
constexpr int kIndexWidth = 206;
/// From this width on there is room for contents and page, px.
constexpr int kWide = 600;
constexpr int kPageRole = Qt::UserRole;

/// The file to which a link of a page points.
QString fileOf(const QUrl& url)
{
    if (url.scheme() != QStringLiteral("qrc"))
        return url.toLocalFile();
    // Files of the source folder "resources" are built in without that folder.
    static const QString kResources = QStringLiteral("/resources/");
    const QString path = url.path();
    return QLatin1Char(':') + (path.startsWith(kResources) ? path.mid(kResources.size() - 1) : path);
}

bool isRecipe(const QString& fileName)
{
    return fileName.endsWith(QStringLiteral(".json")) && fileName.contains(QStringLiteral("/recipes/")) &&
           QFile::exists(fileName);
}

} // namespace

HelpPanel::HelpPanel(QWidget* parent)
    : Bar(parent),
      m_page(new HelpPage(this)),
      m_index(new QWidget(this)),
      m_search(new QLineEdit(this)),
      m_list(new QListWidget(this)),
      m_play(new QPushButton(this)),
      m_back(new BarButton(BarButton::Look::Icon, this)),
      m_contents(new BarButton(BarButton::Look::Icon, this))
{
    const auto name = [](BarButton* button, const char* icon_, const QString& text, const QString& tip) {
        button->setIcon(icon(QString::fromLatin1(icon_)));
        button->setAccessibleName(text);
        button->setToolTip(tip.isEmpty() ? text : tip);
    };
    auto* close = new BarButton(BarButton::Look::Icon, this);
    name(m_back, "back", tr("Back"), tr("Back to the previous page"));
    name(m_contents, "contents", tr("Contents"), {});
    name(close, "close", tr("Close the help"), tr("Close the help (Esc)"));
    m_back->setObjectName(QStringLiteral("helpBack"));
    m_contents->setObjectName(QStringLiteral("helpContentsButton"));
    m_contents->setCheckable(true);
    close->setObjectName(QStringLiteral("helpClose"));

    m_search->setObjectName(QStringLiteral("helpSearch"));
    m_search->setPlaceholderText(tr("Search"));
    m_search->setAccessibleName(tr("Search the help"));
    m_search->setClearButtonEnabled(true);
    m_search->setMinimumHeight(theme::kTarget);
    m_list->setObjectName(QStringLiteral("helpList"));
    m_list->setAccessibleName(tr("Help pages"));
    m_list->setFrameShape(QFrame::NoFrame);
    m_list->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    m_list->setVerticalScrollMode(QAbstractItemView::ScrollPerPixel);
    QScroller::grabGesture(m_list->viewport(), QScroller::TouchGesture);
    m_play->setObjectName(QStringLiteral("helpPlay"));
    m_play->setMinimumHeight(theme::kTarget);
    m_page->setObjectName(QStringLiteral("helpPage"));

    auto* index = new QVBoxLayout(m_index);
    index->setContentsMargins(10, 0, 0, 10);
    index->setSpacing(8);
    index->addWidget(m_search);
    index->addWidget(m_list, 1);
    auto* head = new QHBoxLayout;
    head->setContentsMargins(6, 6, 6, 2);
    head->setSpacing(2);
    auto* title = new QLabel(tr("Help"), this);
    head->addWidget(m_back);
    head->addWidget(m_contents);
    head->addSpacing(6);
    head->addWidget(title, 1);
    head->addWidget(close);
    auto* page = new QVBoxLayout;
    page->setSpacing(0);
    page->addWidget(m_page, 1);
    auto* foot = new QHBoxLayout;
    foot->setContentsMargins(18, 8, 18, 14);
    foot->addWidget(m_play, 1);
    page->addLayout(foot);
    auto* body = new QHBoxLayout;
    body->setSpacing(0);
    body->addWidget(m_index);
    body->addLayout(page, 1);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    column->addLayout(head);
    column->addLayout(body, 1);

    connect(m_back, &QToolButton::clicked, m_page, &QTextBrowser::backward);
    connect(m_page, &QTextBrowser::backwardAvailable, m_back, &QWidget::setEnabled);
    connect(m_page, &QTextBrowser::sourceChanged, this, &HelpPanel::followPage);
    connect(m_page, &QTextBrowser::anchorClicked, this, &HelpPanel::followLink);
    connect(m_contents, &QToolButton::toggled, this, &HelpPanel::showContents);
    connect(close, &QToolButton::clicked, this, &HelpPanel::closeAsked);
    connect(m_search, &QLineEdit::textChanged, this, &HelpPanel::fillContents);
    connect(m_search, &QLineEdit::returnPressed, this, [this] {
        if (const QStringList found = m_book.find(m_search->text()); !found.isEmpty())
            showPage(found.constFirst());
    });
    const auto open = [this](const QListWidgetItem* item) {
        if (item && !item->data(kPageRole).toString().isEmpty())
            showPage(item->data(kPageRole).toString());
    };
    connect(m_list, &QListWidget::itemClicked, this, open);
    connect(m_list, &QListWidget::itemActivated, this, open);
    connect(m_play, &QPushButton::clicked, this, [this] {
        if (const QString file = recipe(); !file.isEmpty())
            Q_EMIT recipeAsked(file);
        else
            Q_EMIT tourAsked();
    });
    m_back->setEnabled(false);
    fillContents();
    showPage(HelpBook::kIndex);
    m_page->clearHistory();
}

int HelpPanel::widthIn(int windowWidth)
{
    return std::clamp(windowWidth * 44 / 100, kLeastWidth, kMostWidth);
}

QString HelpPanel::page() const
{
    return m_page->url().fileName().section(QLatin1Char('.'), 0, 0);
}

void HelpPanel::showPage(const QString& page)
{
    const QUrl url = m_book.url(page);
    m_page->setSource(url.isEmpty() ? m_book.url(HelpBook::kIndex) : url);
    m_contents->setChecked(false);
}

QString HelpPanel::recipe() const
{
    for (const QString& link : m_page->links()) {
        const QString file = fileOf(m_page->url().resolved(QUrl(link)));
        if (isRecipe(file) && file.contains(QStringLiteral("/help/recipes/")))
            return file;
    }
    return {};
}

void HelpPanel::followLink(const QUrl& link)
{
    const QUrl url = m_page->url().resolved(link);
    if (!url.isLocalFile() && url.scheme() != QStringLiteral("qrc")) {
        QDesktopServices::openUrl(url);
        return;
    }
    const QString file = fileOf(url);
    const QString page = url.fileName().section(QLatin1Char('.'), 0, 0);
    if (isRecipe(file)) {
        Q_EMIT recipeAsked(file);
    } else if (QUrl own = m_book.url(page); !own.isEmpty()) {
        // If a page is missing, a page of another language replaces it.
        own.setFragment(url.fragment());
        m_page->setSource(own);
    } else if (QFile::exists(file)) {
        m_page->setSource(QUrl(QStringLiteral("qrc") + file));
    }
}

void HelpPanel::followPage()
{
    const bool isIndex = page() == HelpBook::kIndex;
    m_play->setVisible(isIndex || !recipe().isEmpty());
    m_play->setText(isIndex ? tr("Show me around") : tr("Play this recipe"));
    m_play->setIcon(isIndex ? QIcon() : icon(QStringLiteral("play")));
    const QSignalBlocker blocker(m_list);
    m_list->setCurrentItem(nullptr);
    for (int row = 0; row < m_list->count(); ++row) {
        if (m_list->item(row)->data(kPageRole).toString() == page())
            m_list->setCurrentRow(row);
    }
}

void HelpPanel::fillContents()
{
    m_list->clear();
    const auto add = [this](const QString& title, const QString& page) {
        auto* item = new QListWidgetItem(title, m_list);
        item->setData(kPageRole, page);
        item->setSizeHint({0, page.isEmpty() ? theme::kTarget - 8 : theme::kTarget});
        if (!page.isEmpty())
            return;
        item->setFlags(Qt::NoItemFlags);
        item->setTextAlignment(Qt::AlignLeft | Qt::AlignBottom);
    };
    if (const QString words = m_search->text().simplified(); !words.isEmpty()) {
        const QStringList found = m_book.find(words);
        for (const QString& page : found)
            add(m_book.title(page), page);
        if (found.isEmpty())
            add(tr("Nothing found"), {});
    } else {
        for (const HelpBook::Section& section : m_book.contents()) {
            // The first page is listed without a heading.
            if (section.entries.size() > 1)
                add(section.title, {});
            for (const HelpBook::Entry& entry : section.entries)
                add(entry.title, entry.page);
        }
    }
    followPage();
}

void HelpPanel::showContents(bool shown)
{
    m_isContentsAsked = shown;
    arrange();
    if (shown)
        m_search->setFocus();
}

void HelpPanel::resizeEvent(QResizeEvent* event)
{
    Bar::resizeEvent(event);
    arrange();
}

void HelpPanel::arrange()
{
    const bool isWide = width() >= kWide;
    m_contents->setVisible(!isWide);
    m_index->setVisible(isWide || m_isContentsAsked);
    m_page->setVisible(isWide || !m_isContentsAsked);
    m_index->setMinimumWidth(isWide ? kIndexWidth : 0);
    m_index->setMaximumWidth(isWide ? kIndexWidth : QWIDGETSIZE_MAX);
    m_index->layout()->setContentsMargins(10, 0, isWide ? 0 : 10, 10);
}

} // namespace espalier
