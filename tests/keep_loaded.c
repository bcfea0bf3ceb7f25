/* Preloaded into sanitized tests: libraries stay loaded, so that the leak checker can still tell at
   the end whose allocation it looks at, and tests/leaks.supp can name drivers and layers. */
int dlclose(void* handle)
{
    (void)handle;
    return 0;
}
