// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/Language.h"

#include <QCoreApplication>
#include <QLocale>
#include <QTranslator>

namespace espalier {

namespace {

const QString kName = QStringLiteral("language");

void install(const QLocale& locale, const QString& texts)
{
    auto* translator = new QTranslator(QCoreApplication::instance());
    translator->setObjectName(kName);
    if (translator->load(locale, texts, QStringLiteral("_"), QStringLiteral(":/translations")))
        QCoreApplication::installTranslator(translator);
}

} // namespace

void speakLanguage(const QString& code)
{
    // A deleted translator removes its texts.
    qDeleteAll(QCoreApplication::instance()->findChildren<QTranslator*>(kName, Qt::FindDirectChildrenOnly));
    const QLocale locale = code.isEmpty() ? QLocale::system() : QLocale(code);
    QLocale::setDefault(locale);
    install(locale, QStringLiteral("espalier"));
    install(locale, QStringLiteral("qtbase"));
}

} // namespace espalier
