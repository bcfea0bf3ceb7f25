/* A plug-in of a limn of other days: nothing behind the version may be read. */
const char* const limn_plugin[] = {"0.0.9"};
