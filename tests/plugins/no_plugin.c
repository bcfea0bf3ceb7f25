/* A module, but no plug-in. */
int something = 1;
