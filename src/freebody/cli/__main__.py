from freebody.cli import main

main()
