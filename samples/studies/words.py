"""The language of a page of results."""

from french import FRENCH

LANGUAGES = ("en", "fr")


class Words:
    """Texts of a page in a language. A text without a translation, such as a sentence of a user's study, stays."""

    def __init__(self, language: str = "en") -> None:
        self.language = language

    def __call__(self, text: str, *arguments: object) -> str:
        """The text with its arguments at {0}, {1}, ..."""
        translated = FRENCH.get(text, text) if self.language == "fr" else text
        return translated.format(*arguments) if arguments else translated
