// libsimilitude is the framework's parts as one shared library; it has no code of its own.
